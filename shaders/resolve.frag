// The scene in the window: from linear light to the screen.
#include "frame.glsl"
#include "tone.glsl"

uniform sampler2D light_map;

in vec2 place;
out vec4 screen;

void main() {
    vec3 light = texture(light_map, place).rgb;
    screen = vec4(tone(light, gl_FragCoord.xy, vec2(ray_right.w, ray_up.w)), 1.0);
}
