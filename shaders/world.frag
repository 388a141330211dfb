// Adds the key light where no shadow falls.
#include "frame.glsl"
#include "tone.glsl"

uniform sampler2DShadow shadow_map;

in vec3 base;
in vec3 key;
in vec3 shadow_at;
out vec4 screen;

// The share of four neighbouring samples, each filtered, that the key light reaches.
float reached(vec3 at) {
    const float STEP = 0.8 / 1024.0;
    return 0.25 * (texture(shadow_map, at + vec3(-STEP, -STEP * 0.4, 0.0)) + texture(shadow_map, at + vec3(STEP * 0.4, -STEP, 0.0))
                 + texture(shadow_map, at + vec3(STEP, STEP * 0.4, 0.0)) + texture(shadow_map, at + vec3(-STEP * 0.4, STEP, 0.0)));
}

void main() {
    screen = vec4(tone(base + key * reached(shadow_at), gl_FragCoord.xy, vec2(ray_right.w, ray_up.w)), 1.0);
}
