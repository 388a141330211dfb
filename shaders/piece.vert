// A set piece that stands still: its mesh is that of all its like, its light is read from a table.
#include "lit.glsl"
#include "wind.glsl"
#include "placed.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 colour;   // rgb: sRGB
layout(location = 3) in vec4 traits;   // glow, sway

uniform usampler2D piece_light;   // r: openness to the sky in the highest byte; g: as `baked` in world.vert

const int ROW = 2048;   // the same as in src/shell/render/crowd.rs

vec4 bytes(uint word) {
    return vec4(word & 255u, word >> 8 & 255u, word >> 16 & 255u, word >> 24) / 255.0;
}

void main() {
    int entry = int(place_look.x) + gl_VertexID;
    uvec2 light = texelFetch(piece_light, ivec2(entry % ROW, entry / ROW), 0).rg;
    vec3 n = placed_normal(normal.xyz);
    vec3 at = blown(placed(position), traits);
    light_up(at, n, colour.rgb * colour.rgb, bytes(light.r).a, traits.x, bytes(light.g), moving_lamps(at, n));
    gl_Position = view_proj * vec4(at, 1.0);
}
