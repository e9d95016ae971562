#version 150 core
in float distanceToEye;
out vec4 colour;
uniform vec3 edgeColour;
uniform float hazeDistance;

// Far away lines would lie side by side and blacken the picture: they fade.
void main() {
    colour = vec4(edgeColour, 0.42 * (1.0 - smoothstep(0.15, 0.8, distanceToEye / hazeDistance)));
}
