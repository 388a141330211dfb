// How the wind moves a corner: traits.y says how far.
vec3 blown(vec3 at, vec4 traits) {
    float phase = eye.w * 1.7 + at.x * 0.6 + at.z * 0.9;
    return at + vec3(sin(phase) + 0.5 * sin(phase * 2.3), 0.0, 0.4 * cos(phase * 1.3)) * (traits.y * 0.14);
}
