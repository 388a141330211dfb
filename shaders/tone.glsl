// From linear light to the screen.

// Rolls highlights off softly, encodes as sRGB (a fit in square roots, error below 0.1 %), darkens the corners a little
// and hides steps between the 8-bit values under a fixed fine pattern. `place`: 0 to 1 over the picture.
vec3 tone(vec3 light, vec2 pixel, vec2 place) {
    vec2 centred = place * 2.0 - 1.0;
    light *= 1.0 - 0.17 * dot(centred, centred);
    light = light * (1.0 + light * 0.08) / (1.0 + light * 0.62);
    vec3 root = sqrt(max(light, 0.0));
    vec3 fourth = sqrt(root);
    vec3 screen = 0.662002687 * root + 0.684122060 * fourth - 0.323583601 * sqrt(fourth) - 0.0225411470 * light;
    float grain = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
    return screen + (grain - 0.5) / 255.0;
}
