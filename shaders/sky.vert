// The sky behind everything, worked out at the corners of a coarse grid over the picture.
#include "light.glsl"

layout(location = 0) in vec4 corner;   // xy: -1 to 1

out vec3 light;

void main() {
    vec3 direction = normalize(ray_forward.xyz + corner.x * ray_right.xyz + corner.y * ray_up.xyz);
    float up = max(direction.y, 0.0);
    light = mix(haze(direction), rose.rgb, smoothstep(0.0, 0.24, up));
    light = mix(light, zenith.rgb, smoothstep(0.12, 0.60, up));
    float towards = max(dot(direction, normalize(SUNSET)), 0.0);
    float halo = towards * towards;
    halo *= halo;
    light += haze_warm.rgb * (0.35 * halo * halo + 0.55 * pow(towards, 40.0));
    gl_Position = vec4(corner.xy, 1.0, 1.0);
}
