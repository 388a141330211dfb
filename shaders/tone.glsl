// From linear light to the screen.

// Rolls highlights off softly (light * (1 + 0.08 light) / (1 + 0.62 light)) and encodes as sRGB, both by one fit in the square
// root (error at most 2 of 255 up to a light of 4), darkens the corners a little and hides steps between the 8-bit values
// under a fixed fine pattern. `place`: 0 to 1 over the picture.
vec3 tone(vec3 light, vec2 pixel, vec2 place) {
    vec2 centred = place * 2.0 - 1.0;
    light *= 1.0 - 0.17 * dot(centred, centred);
    light = max(light, 0.0);
    vec3 root = sqrt(light);
    vec3 screen = (0.0741 * root + 31.018 * light) / (1.0 + 21.065 * root + 15.166 * light);
    float grain = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
    return screen + (grain - 0.5) / 255.0;
}
