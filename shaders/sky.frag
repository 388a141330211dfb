// The sky as its corners have it.
in vec3 light;
out vec4 screen;

void main() {
    screen = vec4(light, 1.0);
}
