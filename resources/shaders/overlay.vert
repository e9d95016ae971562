#version 150 core
// A tint over faces that are there already: a little in front of them, behind their edges.
in vec3 vertexPosition;
out vec3 eyeSpace;
uniform mat4 modelView;
uniform mat4 mvp;
uniform float lift;
#pragma include clip.inc

void main() {
    clip(vertexPosition);
    eyeSpace = vec3(modelView * vec4(vertexPosition, 1.0));
    gl_Position = mvp * vec4(vertexPosition, 1.0);
    gl_Position.z -= lift * gl_Position.w;
}
