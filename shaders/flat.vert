// Debug triangles.
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 colour;

out vec4 tint;

void main() {
    tint = vec4(colour.rgb * colour.a, colour.a);
    gl_Position = view_proj * vec4(position, 1.0);
}
