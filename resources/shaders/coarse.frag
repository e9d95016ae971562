#version 330 core
// Copies the picture that was coloured with fewer pixels while the camera moves, with its depths.
out vec4 colour;
uniform sampler2D coarseColour;
uniform sampler2D coarseDepth;
uniform float coarseSpacing;  // pixels a side of each of its pixels

void main() {
    ivec2 pixel = min(ivec2(gl_FragCoord.xy / coarseSpacing), textureSize(coarseColour, 0) - 1);
    colour = texelFetch(coarseColour, pixel, 0);
    gl_FragDepth = texelFetch(coarseDepth, pixel, 0).x;
}
