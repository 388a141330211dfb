// How a corner is moved: by the matrix of its part and by the wind.
layout(std140) uniform PartsBlock {
    mat4 parts[32];
};

vec3 placed(vec3 position, vec4 traits) {
    vec3 at = (parts[int(traits.z * 255.0 + 0.5)] * vec4(position, 1.0)).xyz;
    float phase = eye.w * 1.7 + at.x * 0.6 + at.z * 0.9;
    return at + vec3(sin(phase) + 0.5 * sin(phase * 2.3), 0.0, 0.4 * cos(phase * 1.3)) * (traits.y * 0.14);
}

vec3 turned(vec3 normal, vec4 traits) {
    return normalize(mat3(parts[int(traits.z * 255.0 + 0.5)]) * normal);
}
