// The line around the hero: his mesh, a little larger on the picture and a little behind him.
#include "frame.glsl"
#include "skin.glsl"

layout(location = 0) in vec3 position;
layout(location = 6) in vec4 outwards;   // smooth over the edges, so that the line has no gaps

out vec4 tint;

const float BEHIND = 0.35;   // metres

void main() {
    mat4 moved = skin();
    vec3 at = (moved * vec4(position, 1.0)).xyz;
    vec4 clip = view_proj * vec4(at, 1.0);
    vec4 aside = view_proj * vec4(mat3(moved) * outwards.xyz, 0.0);
    vec2 way = aside.xy * vec2(ray_right.w, ray_up.w);
    way = dot(way, way) > 1e-9 ? normalize(way) : vec2(0.0);
    vec4 far = view_proj * vec4(at + normalize(at - eye.xyz) * BEHIND, 1.0);
    clip.xy += way * outline.w * 2.0 / vec2(ray_right.w, ray_up.w) * clip.w;
    gl_Position = vec4(clip.xy, far.z / far.w * clip.w, clip.w);
    tint = vec4(outline.rgb, 1.0);
}
