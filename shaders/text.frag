// A colour, as far as the picture of all letters covers it.
uniform sampler2D letters;

in vec2 texel;
in vec4 tint;
out vec4 screen;

void main() {
    screen = tint * texture(letters, texel).r;
    // Hides the steps of wide, faint shades under a fixed fine pattern.
    float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    screen += (grain - 0.5) / 255.0 * step(0.001, screen.a) * step(screen.a, 0.995);
}
