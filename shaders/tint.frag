// A plain colour in linear light, premultiplied.
#include "shown.glsl"

in vec4 tint;
out vec4 screen;

void main() {
    screen = shown(tint);
}
