#version 150 core
// A solid of the same size in pixels at any distance, in front of everything. Its points are in pixels above the anchor.
in vec3 vertexPosition;
out vec3 eyeSpace;
uniform mat4 modelView;
uniform mat4 mvp;
uniform vec3 anchor;
uniform float metresPerPixel;  // at one metre from the eye

void main() {
    float depth = max((mvp * vec4(anchor, 1.0)).w, 0.01);
    vec4 place = vec4(anchor + vertexPosition * metresPerPixel * depth, 1.0);
    eyeSpace = vec3(modelView * place);
    gl_Position = mvp * place;
    gl_Position.z = gl_Position.z * 0.0005 - 0.999 * gl_Position.w;
}
