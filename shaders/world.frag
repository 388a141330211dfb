// Adds the key light where no shadow falls.
#include "frame.glsl"

#ifdef SHADOW_TEXELS
uniform sampler2DShadow shadow_map;
#endif

in vec3 base;
in vec3 key;
in vec3 shadow_at;
out vec4 screen;

#ifdef SHADOW_TEXELS
// The share of four neighbouring samples, each filtered, that the key light reaches.
float reached(vec3 at) {
    const float STEP = 0.8 / SHADOW_TEXELS;
    return 0.25 * (texture(shadow_map, at + vec3(-STEP, -STEP * 0.4, 0.0)) + texture(shadow_map, at + vec3(STEP * 0.4, -STEP, 0.0))
                 + texture(shadow_map, at + vec3(STEP, STEP * 0.4, 0.0)) + texture(shadow_map, at + vec3(-STEP * 0.4, STEP, 0.0)));
}
#endif

void main() {
#ifdef SHADOW_TEXELS
    screen = vec4(base + key * reached(shadow_at), 1.0);
#else
    screen = vec4(base + key, 1.0);
#endif
}
