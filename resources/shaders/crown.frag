#version 150 core
// Trees in a soft light from above.
in vec3 eyeSpace;
out vec4 colour;
uniform mat4 inverseViewMatrix;
uniform vec3 baseColour;
uniform vec3 haze;
uniform float hazeDistance;

void main() {
    vec3 normal = mat3(inverseViewMatrix) * normalize(cross(dFdx(eyeSpace), dFdy(eyeSpace)));
    float sun = max(dot(normal, normalize(vec3(-0.55, -0.70, 0.62))), 0.0);
    vec3 lit = baseColour * (0.72 + 0.16 * normal.z + 0.24 * sun);
    colour = vec4(mix(lit, haze, 0.75 * smoothstep(0.4, 1.0, length(eyeSpace) / hazeDistance)), 1.0);
}
