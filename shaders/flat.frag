// A plain colour, given as it shall appear on the screen.
in vec4 tint;
out vec4 screen;

void main() {
    screen = tint;
}
