// Adds the key light where no shadow falls.
#include "light.glsl"
#include "shadow.glsl"
#include "shown.glsl"

in vec3 base;
in vec3 key;
in vec4 shadow_at;
#ifdef PER_PIXEL
in vec3 lit_albedo;
in vec3 lit_at;
flat in vec3 lit_normal;
in float clear;
#endif
out vec4 screen;

void main() {
    vec3 light = base + key * reached(shadow_at);
#ifdef PER_PIXEL
    light += lit_albedo * lamps(lit_at, lit_normal) * clear;
#endif
    screen = shown(light);
}
