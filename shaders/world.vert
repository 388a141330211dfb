// Everything made of flat facets that stands still or is moved by the wind.
#include "lit.glsl"
#include "wind.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 colour;   // rgb: sRGB; a: openness to the sky
layout(location = 3) in vec4 traits;   // glow, sway, nothing, whether it is baked
layout(location = 4) in vec4 baked;    // rgb: root of a quarter of the light of the lamps that stand still; a: share of the key light

void main() {
    vec3 at = blown(position, traits);
    vec3 albedo = colour.rgb * colour.rgb;   // close enough to the sRGB curve for painted colours
    light_up(at, normal.xyz, albedo, colour.a, traits.x, baked, moving_lamps(at, normal.xyz));
    gl_Position = view_proj * vec4(at, 1.0);
}
