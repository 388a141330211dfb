// The halo of a lamp: one instance, a square.
#include "light.glsl"

layout(location = 0) in vec4 place;   // xyz: lamp; w: radius
layout(location = 1) in vec4 colour;

out vec2 spot;
out vec4 tint;

void main() {
    vec2 corner = vec2(gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4, gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5) * 2.0 - 1.0;
    spot = corner;
    tint = vec4(colour.rgb * 0.26 * flicker(place.x), 0.0);
    vec3 at = place.xyz + (normalize(ray_right.xyz) * corner.x + normalize(ray_up.xyz) * corner.y) * place.w;
    gl_Position = view_proj * vec4(at, 1.0);
}
