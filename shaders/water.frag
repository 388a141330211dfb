// Dark and clear from above, the sky's mirror from aside; facets catch the sunset.
#include "light.glsl"
#include "shown.glsl"

in vec3 at;
out vec4 screen;

void main() {
    vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
    vec3 from = normalize(at - eye.xyz);
    vec3 mirrored = reflect(from, normal);
    float grazing = 1.0 - abs(dot(from, normal));
    float mirror = 0.05 + 0.60 * grazing * grazing * grazing * grazing;
    vec3 sky = haze(vec3(mirrored.x, 0.0, mirrored.z)) * 1.05;
    float glint = max(dot(mirrored, SUNSET), 0.0);
    vec3 light = mix(vec3(0.012, 0.060, 0.078), sky, mirror) + haze_warm.rgb * pow(glint, 24.0);
    light = mix(light, haze(from), fog(at) * 0.8);
    screen = shown(light);
}
