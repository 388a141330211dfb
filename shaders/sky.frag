// Dusk: from a burning horizon through rose to a deep blue, with the glow of a sun that has just gone.
#include "light.glsl"

in vec3 ray;
out vec4 screen;

void main() {
    vec3 direction = normalize(ray);
    float up = max(direction.y, 0.0);
    vec3 low = haze(direction);
    vec3 rose = vec3(0.46, 0.25, 0.30);
    vec3 high = vec3(0.045, 0.085, 0.20);
    vec3 light = mix(low, rose, smoothstep(0.0, 0.22, up));
    light = mix(light, high, smoothstep(0.12, 0.62, up));
    float towards = max(dot(direction, normalize(SUNSET)), 0.0);
    float disc = pow(towards, 24.0);
    light += vec3(1.0, 0.46, 0.16) * disc * 0.8 + vec3(1.4, 0.9, 0.5) * smoothstep(0.9991, 0.9995, towards);
    screen = vec4(light, 1.0);
}
