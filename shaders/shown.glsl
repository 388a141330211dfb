// Light as the texels of the scene hold it: as it is, or, at a preset that has no room for that, as the screen will show it.
#include "frame.glsl"
#ifdef SCREEN_TEXELS
#include "tone.glsl"

const float ADDED = 0.48;   // light that is added to a picture that is encoded already: about right over a dusky wall

vec4 shown(vec3 light) {
    return vec4(curve(light * cloud.w) + grain(gl_FragCoord.xy), 1.0);
}

// The same for what is premultiplied; without alpha it only adds light.
vec4 shown(vec4 tint) {
    if (tint.a < 0.001) return vec4(tint.rgb * cloud.w * ADDED, 0.0);
    return vec4(curve(tint.rgb * cloud.w / tint.a) * tint.a, tint.a);
}
#else
vec4 shown(vec3 light) {
    return vec4(light, 1.0);
}

vec4 shown(vec4 tint) {
    return tint;
}
#endif
