// Everything made of flat facets. The lighting is done per corner; a fragment only asks whether the key light reaches it.
#include "light.glsl"
#include "parts.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 colour;   // rgb: sRGB; a: openness to the sky
layout(location = 3) in vec4 traits;   // glow, sway, part

out vec3 base;       // light that leaves towards the eye without the key light, fog included
out vec3 key;        // what the key light adds where it arrives
out vec3 shadow_at;

void main() {
    vec3 at = placed(position, traits);
    vec3 n = turned(normal.xyz, traits);
    vec3 albedo = colour.rgb * colour.rgb;   // close enough to the sRGB curve for painted colours
    float haze_share = fog(at);
    vec3 lit = albedo * fill(at, n, colour.a) + albedo * traits.x * 2.6;
    base = mix(lit, haze(normalize(at - eye.xyz)), haze_share);
    float facing = max(dot(n, sun.xyz), 0.0);
    key = albedo * KEY * facing * mix(0.45, 1.0, colour.a) * (1.0 - traits.x) * (1.0 - haze_share);
    shadow_at = (shadow_proj * vec4(at + n * (0.13 - 0.08 * facing) + sun.xyz * 0.04, 1.0)).xyz;
    gl_Position = view_proj * vec4(at, 1.0);
}
