// What floats in the air: each is a square of six vertices alike; where it is follows from its seed and the time alone.
#include "light.glsl"

layout(location = 0) in vec4 seed;    // xyz: 0 to 1; w: 0 dust, 1 ember, 2 puff, 3 leaf, 4 shadow below the hero
layout(location = 1) in float phase;  // 0 to 1

out vec2 spot;
out vec4 tint;

const vec3 ROOM = vec3(36.0, 20.0, 14.0);   // the box around the camera's aim in which they live
const vec3 WIND = vec3(1.0, 0.0, 0.0);

// A place that drifts through the room; it wraps where nobody looks.
vec3 drifting(vec3 speed, float play) {
    vec3 middle = vec3(eye.xy, -2.5);
    vec3 p = seed.xyz * ROOM + speed * eye.w;
    p += vec3(sin(eye.w * 0.7 + phase * 40.0), sin(eye.w * 0.9 + phase * 70.0), sin(eye.w * 0.5 + phase * 90.0)) * play;
    return middle + (fract((p - middle) / ROOM) - 0.5) * ROOM;
}

// A leaf falls aslant, swings and turns over; gives the places of its corners.
vec3 leaf(vec2 corner, out float shade) {
    float gust = 0.6 + 0.4 * sin(eye.w * 0.31 + phase * 6.0);
    vec3 at = drifting(WIND * (1.6 + phase) + vec3(0.0, -0.55 - 0.4 * phase, 0.0), 0.8 * gust);
    float roll = eye.w * (1.1 + 1.7 * phase) + phase * 60.0;
    float pitch = eye.w * (0.8 + 1.1 * seed.x) + seed.y * 60.0;
    vec3 along = vec3(cos(roll), sin(roll) * cos(pitch), sin(roll) * sin(pitch));
    vec3 aside = normalize(cross(along, vec3(0.3, cos(pitch), sin(pitch) + 0.4)));
    shade = 0.45 + 0.55 * abs(cross(along, aside).y);
    return at + along * (corner.x * 0.13) + aside * (corner.y * 0.055);
}

void main() {
    int which = gl_VertexID % 6;
    bool right = which == 1 || which == 2 || which == 4;
    bool top = which == 2 || which == 4 || which == 5;
    vec2 corner = vec2(right, top) * 2.0 - 1.0;
    vec3 at = vec3(0.0);
    vec3 across = normalize(ray_right.xyz);
    vec3 up = normalize(ray_up.xyz);
    float size = 0.0;
    spot = corner;
    tint = vec4(0.0);
    if (seed.w < 0.5) {
        at = drifting(WIND * 0.25 + vec3(0.0, 0.05, 0.0), 0.35);
        size = phase < ground_fill.w * MOTES ? 0.014 + 0.026 * seed.x : 0.0;
        tint = vec4(haze_warm.rgb * 0.8 + sky_fill.rgb * 0.4, 0.4) * (0.35 + 0.35 * sin(eye.w * 1.3 + phase * 50.0));
    } else if (seed.w < 1.5) {
        at = drifting(WIND * 0.45 + vec3(0.0, 0.75, 0.0), 0.35);
        size = phase < zenith.w * MOTES ? 0.020 + 0.022 * seed.x : 0.0;
        tint = vec4(2.2, 0.80, 0.18, 0.0) * (0.6 + 0.5 * sin(eye.w * 6.0 + phase * 80.0));
    } else if (seed.w < 2.5) {
        float age = puff.w;
        float side = seed.x < 0.5 ? -1.0 : 1.0;
        float way = (0.25 + 1.1 * phase) * (1.0 - (1.0 - age) * (1.0 - age));
        bool wet = key_light.w > 0.5;
        float rise = wet ? (2.4 + 3.0 * seed.y) * age - 4.4 * age * age : (0.12 + 0.40 * seed.y) * age;
        at = puff.xyz + vec3(side * way, 0.06 + rise, 0.6 * (seed.z - 0.3));
        size = (0.4 + 0.6 * scene.w) * (wet ? 0.07 + 0.08 * seed.y : (0.12 + 0.20 * seed.y) * (0.5 + age)) * step(0.001, scene.w);
        vec3 colour = wet ? haze_cool.rgb * 2.2 + 0.1 : (sky_fill.rgb + key_light.rgb * 0.30) * vec3(0.62, 0.55, 0.46);
        tint = vec4(colour, 1.0) * (wet ? 0.9 : 0.62) * (1.0 - age);
    } else if (seed.w < 3.5) {
        // A rhomb of full colour: the spot's middle everywhere.
        vec2 rhomb = right == top ? vec2(right ? 1.0 : -1.0, 0.0) : vec2(0.0, top ? 1.0 : -1.0);
        float shade;
        at = leaf(phase < sky_fill.w * MOTES ? rhomb : vec2(0.0), shade);
        vec3 colour = mix(vec3(0.50, 0.26, 0.06), vec3(0.42, 0.44, 0.12), seed.z);
        float haze_share = fog(at);
        tint = vec4(mix(colour * (fill(vec3(0.0, 1.0, 0.0), 1.0) + key_light.rgb * shade * 0.8), haze(normalize(at - eye.xyz)), haze_share), 1.0);
        spot = vec2(0.0);
    } else {
        float height = max(hero.y - hero.w, 0.0);
        float near = max(1.0 - height / 5.0, 0.0);
        across = vec3(1.0, 0.0, 0.0);
        up = vec3(0.0, 0.0, -0.75);
        at = vec3(hero.x, hero.w + 0.05, 0.0);
        size = 0.62 + 0.05 * height;
        tint = vec4(0.0, 0.0, 0.0, BLOB * near);
    }
    gl_Position = view_proj * vec4(at + (across * corner.x + up * corner.y) * size, 1.0);
}
