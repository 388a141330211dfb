// From linear light to the screen.

// Rolls highlights off softly (light * (1 + 0.08 light) / (1 + 0.62 light)) and encodes as sRGB, both by one fit in the square
// root (error at most 2 of 255 up to a light of 4).
vec3 curve(vec3 light) {
    vec3 root = sqrt(max(light, 0.0));
    return (0.0741 * root + 31.018 * light) / (1.0 + 21.065 * root + 15.166 * light);
}

// A fixed fine pattern that hides steps between 8-bit values.
float grain(vec2 pixel) {
    return (fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

// What the picture keeps of its light towards the corners. `place`: 0 to 1 over the picture.
float vignette(vec2 place) {
    vec2 centred = place * 2.0 - 1.0;
    return 1.0 - 0.17 * dot(centred, centred);
}
