// A line of given width in pixels: one instance, six corners.
#include "frame.glsl"

layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 colour;
layout(location = 3) in float width;

out vec4 tint;

void main() {
    vec4 a = view_proj * vec4(from, 1.0);
    vec4 b = view_proj * vec4(to, 1.0);
    const float NEAR = 0.05;   // cut the part behind the camera, or the division would mirror it
    if (a.w < NEAR) a = mix(a, b, clamp((NEAR - a.w) / max(b.w - a.w, 1e-6), 0.0, 1.0));
    if (b.w < NEAR) b = mix(b, a, clamp((NEAR - b.w) / max(a.w - b.w, 1e-6), 0.0, 1.0));
    vec2 size = vec2(ray_right.w, ray_up.w);
    vec2 along = (b.xy / b.w - a.xy / a.w) * size;
    along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1.0, 0.0);
    bool end = gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4;
    float side = gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5 ? 1.0 : -1.0;
    vec4 at = end ? b : a;
    at.xy += (vec2(-along.y, along.x) * side + along * (end ? 0.5 : -0.5)) * width / size * at.w;
    tint = vec4(colour.rgb * colour.a, colour.a);
    gl_Position = at.w < NEAR ? vec4(0.0, 0.0, 2.0, 1.0) : vec4(at.xy, 0.0, at.w);
}
