// Half the size: the mean of four by four texels.
uniform sampler2D light_map;

in vec2 place;
out vec4 screen;

void main() {
    vec2 texel = 1.0 / vec2(textureSize(light_map, 0));
    screen = vec4(0.25 * (texture(light_map, place + texel * vec2(-1.0, -1.0)).rgb + texture(light_map, place + texel * vec2(1.0, -1.0)).rgb
                        + texture(light_map, place + texel * vec2(-1.0, 1.0)).rgb + texture(light_map, place + texel * vec2(1.0, 1.0)).rgb), 1.0);
}
