// The light of one corner. Unless the preset lights each pixel, all of it is worked out here, and a fragment only asks
// whether the key light reaches it.
#include "light.glsl"

out vec3 base;           // light that leaves towards the eye without the key light, haze included
out vec3 key;            // what the key light adds where it arrives
out vec4 shadow_at;      // where that is looked up; w: what was baked
#ifdef PER_PIXEL
out vec3 lit_albedo;
out vec3 lit_at;
flat out vec3 lit_normal;
out float clear;         // share that the haze leaves
#endif

// `open`: openness to the sky; `glow`: share of the colour that shines by itself; `baked`: rgb: root of a quarter of the
// light of the lamps that stand still, a: share of the key light; `other`: light of the lamps that are not among those.
void light_up(vec3 at, vec3 n, vec3 albedo, float open, float glow, vec4 baked, vec3 other) {
    float haze_share = fog(at);
    vec3 light = fill(n, open) + vec3(glow * 2.6);
#ifdef PER_PIXEL
    lit_albedo = albedo;
    lit_at = at;
    lit_normal = n;
    clear = 1.0 - haze_share;
#else
    light += other + baked.rgb * baked.rgb * 4.0 * flicker(0.0);
#endif
    base = mix(albedo * light, haze(normalize(at - eye.xyz)), haze_share);
    float facing = max(dot(n, sun.xyz), 0.0);
    key = albedo * key_light.rgb * facing * mix(0.45, 1.0, open) * (1.0 - glow) * (1.0 - haze_share);
    shadow_at = vec4((shadow_proj * vec4(at + n * (0.13 - 0.08 * facing) + sun.xyz * 0.04, 1.0)).xyz, baked.a);
}

// The same for what moves: nothing is baked.
void light_up(vec3 at, vec3 n, vec3 albedo, float open, float glow) {
    light_up(at, n, albedo, open, glow, vec4(0.0, 0.0, 0.0, 1.0), lamps(at, n));
}
