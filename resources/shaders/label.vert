#version 150 core
// A label of constant size in pixels about a point, moved to whole pixels so that its letters stay sharp.
in vec3 vertexPosition;
in vec3 offset;
in vec3 texel;
out vec2 at;
uniform mat4 mvp;
uniform vec2 viewSize;
#pragma include clip.inc

void main() {
#ifdef UNCLIPPED
    clipNothing();
#else
    clip(vertexPosition);
#endif
    vec4 anchor = mvp * vec4(vertexPosition, 1.0);
    at = texel.xy;
    if (anchor.w <= 0.01) {  // behind the eye
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    vec2 pixel = floor((anchor.xy / anchor.w * 0.5 + 0.5) * viewSize) + offset.xy;
    gl_Position = vec4(floor(pixel + 0.5) / viewSize * 2.0 - 1.0, 0.0, 1.0);
}
