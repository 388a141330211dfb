// The sky as its corners have it.
#include "shown.glsl"

in vec3 light;
out vec4 screen;

void main() {
    screen = shown(light);
}
