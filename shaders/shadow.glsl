// Which share of the key light arrives: by the shadow map, and by what was baked where there is no map.
#ifdef SHADOW_TEXELS
uniform sampler2DShadow shadow_map;

const float TEXEL = 1.0 / SHADOW_TEXELS;

// `at`: xyz: place in the map; w: what was baked.
float reached(vec4 at) {
    vec2 inside = smoothstep(vec2(0.5), vec2(0.46), abs(at.xy - 0.5));
    float share = 0.0;
#ifdef SOFT_SHADOW
    // Twelve places on three rings, each filtered by itself.
    const vec2 RING[12] = vec2[](
        vec2(0.6, 0.2), vec2(-0.2, 0.6), vec2(-0.6, -0.2), vec2(0.2, -0.6),
        vec2(1.0, 1.1), vec2(-1.1, 1.0), vec2(-1.0, -1.1), vec2(1.1, -1.0),
        vec2(2.1, -0.2), vec2(0.2, 2.1), vec2(-2.1, 0.2), vec2(-0.2, -2.1));
    for (int i = 0; i < 12; i++) share += texture(shadow_map, at.xyz + vec3(RING[i] * TEXEL, 0.0));
    share /= 12.0;
#else
    const float STEP = 0.8 * TEXEL;
    share = 0.25 * (texture(shadow_map, at.xyz + vec3(-STEP, -STEP * 0.4, 0.0)) + texture(shadow_map, at.xyz + vec3(STEP * 0.4, -STEP, 0.0))
                  + texture(shadow_map, at.xyz + vec3(STEP, STEP * 0.4, 0.0)) + texture(shadow_map, at.xyz + vec3(-STEP * 0.4, STEP, 0.0)));
#endif
    return mix(at.w, share, inside.x * inside.y);
}
#else
float reached(vec4 at) {
    return at.w;
}
#endif
