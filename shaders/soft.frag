// A soft round spot, premultiplied; without alpha it only adds light.
#include "shown.glsl"

in vec2 spot;
in vec4 tint;
out vec4 screen;

void main() {
    float near = max(1.0 - dot(spot, spot), 0.0);
    screen = shown(tint) * near * near;
}
