#version 150 core
in vec3 eyeSpace;
out vec4 colour;
uniform mat4 inverseViewMatrix;
uniform vec4 tint;

void main() {
    vec3 normal = mat3(inverseViewMatrix) * normalize(cross(dFdx(eyeSpace), dFdy(eyeSpace)));
    float sun = max(dot(normal, normalize(vec3(-0.55, -0.70, 0.62))), 0.0);
    colour = vec4(tint.rgb * (0.66 + 0.16 * normal.z + 0.24 * sun), tint.a);
}
