// Adds a smaller stage of the bloom to a larger one, smoothly.
uniform sampler2D light_map;

in vec2 place;
out vec4 screen;

void main() {
    vec2 texel = 0.75 / vec2(textureSize(light_map, 0));
    screen = vec4(0.25 * (texture(light_map, place + texel * vec2(-1.0, -0.5)).rgb + texture(light_map, place + texel * vec2(0.5, -1.0)).rgb
                        + texture(light_map, place + texel * vec2(1.0, 0.5)).rgb + texture(light_map, place + texel * vec2(-0.5, 1.0)).rgb), 0.0);
}
