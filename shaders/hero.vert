// The hero, moved by his bones.
#include "lit.glsl"
#include "skin.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 colour;   // rgb: square root of linear light
layout(location = 3) in vec4 traits;   // glow

void main() {
    mat4 moved = skin();
    vec3 at = (moved * vec4(position, 1.0)).xyz;
    vec3 n = normalize(mat3(moved) * normal.xyz);
    light_up(at, n, colour.rgb * colour.rgb, 1.0, traits.x);
    // Facets that turn away from the viewer catch the sky behind him: he stands out from any ground.
    float away = 1.0 - max(dot(n, normalize(eye.xyz - at)), 0.0);
    base += rim.rgb * (away * away * away) * (0.6 + 0.4 * n.y) * (1.0 - fog(at)) * (1.0 - traits.x);
    gl_Position = view_proj * vec4(at, 1.0);
}
