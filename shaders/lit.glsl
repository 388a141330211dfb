// The light of one corner, worked out here; a fragment only asks whether the key light reaches it.
#include "light.glsl"

out vec3 base;       // light that leaves towards the eye without the key light, fog included
out vec3 key;        // what the key light adds where it arrives
out vec3 shadow_at;

// `open`: openness to the sky; `glow`: share of the colour that shines by itself.
void light_up(vec3 at, vec3 n, vec3 albedo, float open, float glow) {
    float haze_share = fog(at);
    vec3 lit = albedo * fill(at, n, open) + albedo * glow * 2.6;
    base = mix(lit, haze(normalize(at - eye.xyz)), haze_share);
    float facing = max(dot(n, sun.xyz), 0.0);
    key = albedo * KEY * facing * mix(0.45, 1.0, open) * (1.0 - glow) * (1.0 - haze_share);
    shadow_at = (shadow_proj * vec4(at + n * (0.13 - 0.08 * facing) + sun.xyz * 0.04, 1.0)).xyz;
}
