#version 150 core
// A solid of the same size in pixels at any distance, upright on the screen and in front of everything. Its points are in
// pixels about the anchor; z is up on the screen.
in vec3 vertexPosition;
out vec3 eyeSpace;
uniform mat4 modelView;
uniform mat4 mvp;
uniform mat4 inverseViewMatrix;
uniform vec3 anchor;
uniform float metresPerPixel;  // at one metre from the eye
#pragma include clip.inc

void main() {
    clipNothing();
    float depth = max((mvp * vec4(anchor, 1.0)).w, 0.01);
    mat3 camera = mat3(inverseViewMatrix);
    vec3 upright = camera * vec3(vertexPosition.x, vertexPosition.z, -vertexPosition.y);
    vec4 place = vec4(anchor + upright * metresPerPixel * depth, 1.0);
    eyeSpace = vec3(modelView * place);
    gl_Position = mvp * place;
    gl_Position.z = gl_Position.z * 0.0005 - 0.999 * gl_Position.w;
}
