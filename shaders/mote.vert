// Dust, embers and puffs: each is one instance, a square; where it is follows from its seed and the time alone.
#include "light.glsl"

layout(location = 0) in vec4 seed;    // xyz: 0 to 1; w: 0 dust, 1 ember, 2 puff
layout(location = 1) in float phase;  // 0 to 1

out vec2 spot;
out vec4 tint;

const vec3 ROOM = vec3(34.0, 18.0, 16.0);   // the box around the camera's aim in which motes live

// A mote that drifts through the room; it wraps where nobody looks.
vec3 drifting(vec3 speed, vec3 middle) {
    vec3 p = seed.xyz * ROOM + speed * eye.w;
    p += vec3(sin(eye.w * 0.7 + phase * 40.0), sin(eye.w * 0.9 + phase * 70.0), sin(eye.w * 0.5 + phase * 90.0)) * 0.35;
    return middle + (fract((p - middle) / ROOM) - 0.5) * ROOM;
}

void main() {
    vec3 middle = vec3(eye.xy, -3.0);
    vec3 at;
    float size;
    if (seed.w < 0.5) {
        at = drifting(vec3(0.25, 0.05, 0.0), middle);
        size = 0.016 + 0.022 * phase;
        tint = vec4(FOG_WARM * 0.9, 0.5) * (0.35 + 0.35 * sin(eye.w * 1.3 + phase * 50.0));
    } else if (seed.w < 1.5) {
        at = drifting(vec3(0.45, 0.75, 0.0), middle);
        size = 0.020 + 0.022 * phase;
        tint = vec4(1.0, 0.42, 0.12, 0.0) * (0.6 + 0.5 * sin(eye.w * 6.0 + phase * 80.0));
    } else {
        float age = puff.w;
        float side = seed.x < 0.5 ? -1.0 : 1.0;
        float way = (0.25 + 1.1 * phase) * (1.0 - (1.0 - age) * (1.0 - age));
        at = puff.xyz + vec3(side * way, 0.06 + (0.12 + 0.35 * seed.y) * age, 0.5 * (seed.z - 0.3));
        size = (0.4 + 0.6 * scene.w) * (0.12 + 0.20 * seed.y) * (0.5 + age);
        tint = vec4(0.95, 0.87, 0.74, 1.0) * 0.55 * (1.0 - age) * step(0.001, scene.w);
    }
    vec2 corner = vec2(gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4, gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5) * 2.0 - 1.0;
    spot = corner;
    vec3 right = normalize(ray_right.xyz);
    vec3 up = normalize(ray_up.xyz);
    gl_Position = view_proj * vec4(at + (right * corner.x + up * corner.y) * size, 1.0);
}
