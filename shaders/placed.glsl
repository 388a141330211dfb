// A mesh at a place of its own: one instance.
layout(location = 5) in vec4 place_x;      // rows of the matrix from the mesh to the world
layout(location = 6) in vec4 place_y;
layout(location = 7) in vec4 place_z;
layout(location = 8) in vec4 place_look;   // x: where its light begins in the table, less its first vertex; y: glow, or negative

vec3 placed(vec3 at) {
    vec4 p = vec4(at, 1.0);
    return vec3(dot(place_x, p), dot(place_y, p), dot(place_z, p));
}

vec3 placed_normal(vec3 n) {
    return normalize(vec3(dot(place_x.xyz, n), dot(place_y.xyz, n), dot(place_z.xyz, n)));
}
