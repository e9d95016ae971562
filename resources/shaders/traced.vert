#version 150 core
// One triangle over the whole picture.
in vec3 vertexPosition;
#pragma include clip.inc

void main() {
    clipNothing();
    gl_Position = vec4(vertexPosition.xy, 0.0, 1.0);
}
