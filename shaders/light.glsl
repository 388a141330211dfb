// One key light, a sky, lanterns, haze: all in linear light, all from the frame's mood.
#include "frame.glsl"

const int LAMPS = 16;
const int MOVING_LAMPS = 3;
const vec3 SUNSET = vec3(-0.52, 0.09, -0.85);   // where the sun has gone

// Colour of the far haze in a direction.
vec3 haze(vec3 direction) {
    float towards = max(dot(direction, SUNSET), 0.0);
    return mix(haze_cool.rgb, haze_warm.rgb, towards * towards * towards * 0.75);
}

// How much haze lies between the eye and a point: thicker with distance, low over the water, and at once behind the
// plane of play, so that what is walked on stands out.
float fog(vec3 at) {
    float way = max(distance(at, eye.xyz) - 16.0, 0.0);
    float low = exp(-max(at.y - scene.y, 0.0) * 0.09);
    float behind = smoothstep(-0.9, -4.5, at.z);
    return 1.0 - exp(-way * (haze_cool.w + haze_warm.w * low)) * (1.0 - 0.42 * behind);
}

// Light from everywhere, for a surface that is so open to it.
vec3 fill(vec3 normal, float open) {
    return mix(ground_fill.rgb, sky_fill.rgb, normal.y * 0.5 + 0.5) * open;
}

// Light of a lamp at a place, with its reach. The same as in src/shell/render/bake.rs.
vec3 lamp(vec4 place, vec3 colour, vec3 at, vec3 normal) {
    vec3 way = place.xyz - at;
    float square = dot(way, way);
    float far = square / (place.w * place.w);
    float facing = dot(normal, way) * inversesqrt(square + 0.01) * 0.7 + 0.3;
    float left = max(1.0 - far, 0.0);
    return colour * (max(facing, 0.0) * left * left / (1.0 + 9.0 * far));
}

// Light of all lamps; those that are not there are black. The count is fixed so that the loop can be written out: a driver
// without a GPU would else look up the lamps for each corner by itself, which costs more than all the rest.
vec3 lamps(vec3 at, vec3 normal) {
    vec3 light = vec3(0.0);
    for (int i = 0; i < LAMPS; i++) light += lamp(light_at[i], light_colour[i].rgb, at, normal);
    return light;
}

// Light of the lamps that move, which are the first.
vec3 moving_lamps(vec3 at, vec3 normal) {
    vec3 light = vec3(0.0);
    for (int i = 0; i < MOVING_LAMPS; i++) light += lamp(light_at[i], light_colour[i].rgb * step(float(i) + 0.5, scene.z), at, normal);
    return light;
}

// The share of light from a lamp that breathes.
float flicker(float seed) {
    return 1.0 + 0.035 * sin(eye.w * 9.0 + seed * 3.0) + 0.025 * sin(eye.w * 23.0 + seed * 5.0);
}
