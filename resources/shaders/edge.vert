#version 150 core
in vec3 vertexPosition;
out float distanceToEye;
uniform mat4 modelView;
uniform mat4 mvp;
#pragma include clip.inc

void main() {
    clip(vertexPosition);
    distanceToEye = length(vec3(modelView * vec4(vertexPosition, 1.0)));
    gl_Position = mvp * vec4(vertexPosition, 1.0);
    gl_Position.z -= 0.00004 * gl_Position.w;  // in front of the faces that it bounds
}
