// Letters, drawings and rectangles of a page: places are on the screen already.
layout(location = 0) in vec4 place;     // xy: on the screen, -1 to 1; zw: in the picture of all letters
layout(location = 1) in vec4 colour;

out vec2 texel;
out vec4 tint;

void main() {
    texel = place.zw;
    tint = vec4(colour.rgb * colour.a, colour.a);
    gl_Position = vec4(place.xy, 0.0, 1.0);
}
