// What is bright enough to glow, at a quarter of the size: the mean of four by four texels.
uniform sampler2D light_map;

in vec2 place;
out vec4 screen;

#ifdef SCREEN_TEXELS
const float GLOWS = 0.90;   // brightness on the screen from which on things glow
const float MOST = 1.0;
const float STEEP = 5.0;    // how quickly they do
#else
const float GLOWS = 1.30;   // light from which on things glow
const float MOST = 8.0;
const float STEEP = 1.0;
#endif

void main() {
    vec2 texel = 1.0 / vec2(textureSize(light_map, 0));
    vec3 light = texture(light_map, place + texel * vec2(-1.0, -1.0)).rgb + texture(light_map, place + texel * vec2(1.0, -1.0)).rgb
               + texture(light_map, place + texel * vec2(-1.0, 1.0)).rgb + texture(light_map, place + texel * vec2(1.0, 1.0)).rgb;
    light = min(light * 0.25, vec3(MOST));
    float brightest = max(light.r, max(light.g, light.b));
    screen = vec4(light * max(brightest - GLOWS, 0.0) * STEEP / max(brightest, 0.001), 1.0);
}
