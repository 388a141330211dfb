// What stands in the sky: the sun, stars, and shards of cloud that drift. Each corner is given by angles.
#include "light.glsl"

layout(location = 0) in vec4 about;   // x: to the right of straight ahead, y: above the horizon, of the whole thing; z: drift; w: 0 sun, 1 star, 2 cloud
layout(location = 1) in vec4 corner;  // xy: the corner about that; z: how much it is lit from below; w: opacity

out vec4 tint;

const float ROUND = 3.6;   // angle after which clouds come again; wider than any picture

void main() {
    float azimuth = about.x;
    if (about.w > 1.5) azimuth = fract((azimuth + (eye.w + 0.35 * eye.x) * about.z) / ROUND + 0.5) * ROUND - 0.5 * ROUND;
    vec2 angle = vec2(azimuth, about.y) + corner.xy;
    vec3 direction = vec3(sin(angle.x) * cos(angle.y), sin(angle.y), -cos(angle.x) * cos(angle.y));
    float towards = max(dot(direction, SUNSET), 0.0);
    vec3 colour;
    float opacity = corner.w;
    if (about.w < 0.5) {
        colour = haze_warm.rgb * 1.2 + vec3(1.1, 0.75, 0.4) * min(haze_warm.r, 1.0);
    } else if (about.w < 1.5) {
        colour = vec3(0.8, 0.9, 1.0) * (0.7 + 0.3 * sin(eye.w * 1.5 + about.x * 40.0));
        opacity *= rose.w;
    } else {
        vec3 lit = mix(rose.rgb * 1.25, haze_warm.rgb * 1.15, towards * towards);
        colour = mix(cloud.rgb, lit, corner.z * (0.35 + 0.65 * towards));
        opacity *= smoothstep(0.02, 0.10, direction.y);
    }
    tint = vec4(colour * opacity, opacity);
    vec4 at = view_proj * vec4(eye.xyz + direction * 300.0, 1.0);
    gl_Position = vec4(at.xy, at.w, at.w);
}
