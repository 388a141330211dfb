// Dusk: one warm key light, a cool sky, lanterns, fog. All in linear light.
#include "frame.glsl"

const vec3 KEY = vec3(2.0, 1.27, 0.76);
const vec3 SKY_FILL = vec3(0.22, 0.33, 0.50);
const vec3 GROUND_FILL = vec3(0.06, 0.10, 0.13);
const vec3 FOG_COOL = vec3(0.155, 0.205, 0.285);
const vec3 FOG_WARM = vec3(0.98, 0.46, 0.20);
const vec3 SUNSET = vec3(-0.52, 0.09, -0.85);   // where the sun glows in the sky

// Colour of the far haze in a direction.
vec3 haze(vec3 direction) {
    float towards = max(dot(direction, SUNSET), 0.0);
    return mix(FOG_COOL, FOG_WARM, towards * towards * towards * 0.75);
}

// How much haze lies between the eye and a point: thicker with distance, and low over the water.
float fog(vec3 at) {
    float way = max(distance(at, eye.xyz) - 16.0, 0.0);
    float low = exp(-max(at.y - scene.y, 0.0) * 0.09);
    return 1.0 - exp(-way * (0.0145 + 0.010 * low));
}

// Light that arrives from everywhere and from the lanterns.
vec3 fill(vec3 at, vec3 normal, float open) {
    vec3 light = mix(GROUND_FILL, SKY_FILL, normal.y * 0.5 + 0.5) * open;
    int count = int(scene.x);
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
