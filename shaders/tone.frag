// From linear light to the screen: bloom, exposure, vignette, tone curve. The alpha keeps the brightness for the last pass.
#include "frame.glsl"
#include "tone.glsl"

uniform sampler2D light_map;
uniform sampler2D bloom_map;

const float BLOOM = 0.55;   // how much of what glows is added

in vec2 place;
out vec4 screen;

void main() {
#ifdef AT_ONCE
    vec3 light = texture(light_map, place).rgb;
#else
    vec3 light = texelFetch(light_map, ivec2(gl_FragCoord.xy), 0).rgb;   // texel for texel
#endif
    light += texture(bloom_map, place).rgb * BLOOM;
    vec3 shown = curve(light * cloud.w * vignette(place)) + grain(gl_FragCoord.xy);
    screen = vec4(shown, dot(shown, vec3(0.299, 0.587, 0.114)));
}
