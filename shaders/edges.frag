// Of a scene that is as the screen will have it: steps along its edges are smoothed; bloom and vignette are added.
//
// The steps go by motion by mean curvature: colours spread along an edge but not across it, so that it stays as sharp as it
// was (L. Alvarez, P.-L. Lions, J.-M. Morel: Image Selective Smoothing and Edge Detection by Nonlinear Diffusion II, 1992);
// one step of it, without the mixed derivative, which would cost four more looks.
#include "tone.glsl"

uniform sampler2D light_map;
uniform sampler2D bloom_map;

const float BLOOM = 0.28;   // how much of what glows is added
const float STEP = 0.33;    // how far the motion goes
const float FLAT = 0.02;    // difference of brightness that is no edge yet

in vec2 place;
out vec4 screen;

float brightness(vec3 colour) {
    return dot(colour, vec3(0.299, 0.587, 0.114));
}

void main() {
    ivec2 at = ivec2(place * vec2(textureSize(light_map, 0)));
    ivec2 last = textureSize(light_map, 0) - 1;
    vec3 middle = texelFetch(light_map, at, 0).rgb;
    vec3 left = texelFetch(light_map, ivec2(max(at.x - 1, 0), at.y), 0).rgb;
    vec3 right = texelFetch(light_map, ivec2(min(at.x + 1, last.x), at.y), 0).rgb;
    vec3 below = texelFetch(light_map, ivec2(at.x, max(at.y - 1, 0)), 0).rgb;
    vec3 above = texelFetch(light_map, ivec2(at.x, min(at.y + 1, last.y)), 0).rgb;
    vec2 slope = 0.5 * vec2(brightness(right) - brightness(left), brightness(above) - brightness(below));
    vec2 square = slope * slope;
    vec3 spread = square.y * (left + right - 2.0 * middle) + square.x * (below + above - 2.0 * middle);
    vec3 colour = middle + spread * (STEP / (square.x + square.y + FLAT * FLAT)) + texture(bloom_map, place).rgb * BLOOM;
    screen = vec4(colour * sqrt(vignette(place)), 1.0);
}
