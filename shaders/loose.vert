// What moves as a whole: movers, the arrows of belts, shards. All lamps light it.
#include "lit.glsl"
#include "wind.glsl"
#include "placed.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 colour;   // rgb: sRGB; a: openness to the sky
layout(location = 3) in vec4 traits;   // glow, sway

void main() {
    vec3 at = blown(placed(position), traits);
    light_up(at, placed_normal(normal.xyz), colour.rgb * colour.rgb, colour.a, place_look.y < 0.0 ? traits.x : place_look.y);
    gl_Position = view_proj * vec4(at, 1.0);
}
