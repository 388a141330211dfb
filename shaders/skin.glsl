// How bones move the hero's corners. The same order as in src/shell/render/hero.rs.
layout(std140) uniform HeroBlock {
    mat4 bones[40];   // from the pose that the mesh was bound in to the world
    vec4 rim;         // rgb: light along his outline, in linear light
    vec4 outline;     // rgb: colour of the line around him; w: its width in pixels
};

layout(location = 4) in vec4 joints;
layout(location = 5) in vec4 weights;

mat4 skin() {
    ivec4 bone = ivec4(joints * 255.0 + 0.5);
    return bones[bone.x] * weights.x + bones[bone.y] * weights.y + bones[bone.z] * weights.z + bones[bone.w] * weights.w;
}
