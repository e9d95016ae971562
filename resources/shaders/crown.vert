#version 150 core
in vec3 vertexPosition;
out vec3 eyeSpace;
uniform mat4 modelView;
uniform mat4 mvp;
invariant gl_Position;  // the same in the pass that draws depth alone
#pragma include clip.inc

void main() {
    clip(vertexPosition);
    eyeSpace = vec3(modelView * vec4(vertexPosition, 1.0));
    gl_Position = mvp * vec4(vertexPosition, 1.0);
}
