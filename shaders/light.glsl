// One key light, a sky, lanterns, haze: all in linear light, all from the frame's mood.
#include "frame.glsl"

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
    float behind = smoothstep(-1.2, -7.0, at.z);
    return 1.0 - exp(-way * (haze_cool.w + haze_warm.w * low)) * (1.0 - 0.34 * behind);
}

// Light from everywhere, for a surface that is so open to it.
vec3 fill(vec3 normal, float open) {
    return mix(ground_fill.rgb, sky_fill.rgb, normal.y * 0.5 + 0.5) * open;
}

// Light of the first lamps. The same as in src/shell/render/bake.rs.
vec3 lamps(vec3 at, vec3 normal, int count) {
    vec3 light = vec3(0.0);
    for (int i = 0; i < count; i++) {
        vec3 way = light_at[i].xyz - at;
        float far = dot(way, way) / (light_at[i].w * light_at[i].w);
        if (far < 1.0) {
            float facing = dot(normal, way) * inversesqrt(dot(way, way) + 0.01) * 0.7 + 0.3;
            light += light_colour[i].rgb * max(facing, 0.0) * (1.0 - far) * (1.0 - far) / (1.0 + 9.0 * far);
        }
    }
    return light;
}

// The share of light from a lamp that breathes.
float flicker(float seed) {
    return 1.0 + 0.035 * sin(eye.w * 9.0 + seed * 3.0) + 0.025 * sin(eye.w * 23.0 + seed * 5.0);
}
