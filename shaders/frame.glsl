// What every pass knows of the frame. The same order as FrameBlock in src/shell/render/frame.rs.
layout(std140) uniform FrameBlock {
    mat4 view_proj;      // world to clip space
    mat4 shadow_proj;    // world to the shadow map, 0 to 1 on each axis
    vec4 eye;            // xyz: camera; w: seconds
    vec4 ray_right;      // xyz: half the picture's width at distance 1; w: width in pixels
    vec4 ray_up;         // xyz: half its height at distance 1; w: height in pixels
    vec4 ray_forward;    // xyz: where the camera looks
    vec4 sun;            // xyz: towards the key light
    vec4 hero;           // xyz: the hero's foot; w: height of the ground below him
    vec4 puff;           // xyz: where dust or water was last stirred up; w: how long ago, 0 to 1
    vec4 scene;          // x: number of lights; y: height of the water; z: how many lights move; w: strength of the puff
    vec4 key_light;      // rgb: the key light; w: whether the puff is of water
    vec4 sky_fill;       // rgb: light from above; w: how much of the leaves is there
    vec4 ground_fill;    // rgb: light from below; w: of the dust
    vec4 haze_cool;      // rgb: the distance; w: how thick the haze is
    vec4 haze_warm;      // rgb: the distance where the sun has gone; w: how much thicker it is low down
    vec4 zenith;         // rgb: the sky above; w: how many embers
    vec4 rose;           // rgb: the sky between; w: how many stars
    vec4 cloud;          // rgb: clouds away from the sun; w: exposure
    vec4 light_at[16];   // xyz: point light; w: its reach in metres; first those that move
    vec4 light_colour[16];
};
