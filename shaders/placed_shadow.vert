// A mesh at a place of its own, seen from the key light.
#include "frame.glsl"
#include "wind.glsl"
#include "placed.glsl"

layout(location = 0) in vec3 position;
layout(location = 3) in vec4 traits;

void main() {
    vec4 at = shadow_proj * vec4(blown(placed(position), traits), 1.0);
    gl_Position = vec4(at.xyz * 2.0 - 1.0, 1.0);
}
