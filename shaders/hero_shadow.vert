// The hero seen from the key light.
#include "frame.glsl"
#include "skin.glsl"

layout(location = 0) in vec3 position;

void main() {
    vec4 at = shadow_proj * (skin() * vec4(position, 1.0));
    gl_Position = vec4(at.xyz * 2.0 - 1.0, 1.0);
}
