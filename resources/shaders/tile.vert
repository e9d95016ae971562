#version 150 core
// A rectangle on a wall that is there already: in front of the wall and of its edges.
in vec3 vertexPosition;
in vec3 tileColour;
out vec3 shown;
uniform mat4 mvp;
#pragma include clip.inc

void main() {
    clip(vertexPosition);
    shown = tileColour;
    gl_Position = mvp * vec4(vertexPosition, 1.0);
    gl_Position.z -= 0.00002 * gl_Position.w;
}
