// The drowned quarry's water. The waves are made here; the fragment shader finds each facet's slope.
#include "frame.glsl"

layout(location = 0) in vec3 position;

out vec3 at;

void main() {
    float t = eye.w;
    at = position;
    at.xz += 0.9 * vec2(sin(position.z * 1.7 + position.x * 0.3), sin(position.x * 1.3 + position.z * 0.7));
    at.y += 0.22 * sin(at.x * 0.55 + t * 0.9) + 0.20 * sin(at.z * 0.6 - at.x * 0.25 + t * 1.15);
    gl_Position = view_proj * vec4(at, 1.0);
}
