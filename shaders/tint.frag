// A plain colour in linear light, premultiplied.
in vec4 tint;
out vec4 screen;

void main() {
    screen = tint;
}
