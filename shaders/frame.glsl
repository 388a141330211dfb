// What every pass knows of the frame. The same order as FrameBlock in src/shell/render/frame.rs.
layout(std140) uniform FrameBlock {
    mat4 view_proj;      // world to clip space
    mat4 shadow_proj;    // world to the shadow map, 0 to 1 on each axis
    vec4 eye;            // xyz: camera; w: seconds
    vec4 ray_right;      // xyz: half the picture's width at distance 1; w: width in pixels
    vec4 ray_up;         // xyz: half its height at distance 1; w: height in pixels
    vec4 ray_forward;    // xyz: where the camera looks
    vec4 sun;            // xyz: towards the key light
    vec4 hero;           // xyz: the hero's foot
    vec4 puff;           // xyz: the last landing or take-off; w: seconds since then
    vec4 scene;          // x: number of lights; y: height of the water; w: strength of the puff
    vec4 light_at[16];   // xyz: point light; w: its reach in metres
    vec4 light_colour[16];
};
