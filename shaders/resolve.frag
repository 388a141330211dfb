// The picture in the window: enlarged, or with the steps along its edges smoothed.
uniform sampler2D screen_map;   // rgb as on the screen; a: brightness

in vec2 place;
out vec4 screen;

#ifdef ENLARGED
// A plain mean between four texels: their edges are smooth already, and one look at each pixel is what there is time for.
void main() {
    screen = vec4(texture(screen_map, place).rgb, 1.0);
}
#else
void main() {
    vec2 texel = 1.0 / vec2(textureSize(screen_map, 0));
    vec4 middle = texture(screen_map, place);
    float nw = texture(screen_map, place + texel * vec2(-0.5, 0.5)).a;
    float ne = texture(screen_map, place + texel * vec2(0.5, 0.5)).a;
    float sw = texture(screen_map, place + texel * vec2(-0.5, -0.5)).a;
    float se = texture(screen_map, place + texel * vec2(0.5, -0.5)).a;
    float least = min(min(nw, ne), min(sw, se));
    float most = max(max(nw, ne), max(sw, se));
    vec2 across = vec2(sw + se - nw - ne, ne + se - nw - sw);   // along the edge
    float range = most - least;
    if (range > 0.06) {
        vec2 along = across / max(min(abs(across.x), abs(across.y)), 0.05);
        along = clamp(along, -3.0, 3.0) * texel;
        vec3 near = 0.5 * (texture(screen_map, place - along * 0.17).rgb + texture(screen_map, place + along * 0.17).rgb);
        vec4 wide = 0.25 * (texture(screen_map, place - along * 0.5) + texture(screen_map, place + along * 0.5));
        vec3 mixed = near * 0.5 + wide.rgb;
        float shown = dot(mixed, vec3(0.299, 0.587, 0.114));
        middle.rgb = shown < least || shown > most ? near : mixed;
    }
    screen = vec4(middle.rgb, 1.0);
}
#endif
