#version 150 core
// The bottom of a building lies in the ground, and is drawn in front of it.
in vec3 vertexPosition;
uniform mat4 mvp;
#pragma include clip.inc

void main() {
    clip(vertexPosition);
    gl_Position = mvp * vec4(vertexPosition, 1.0);
    gl_Position.z -= 0.00002 * gl_Position.w;
}
