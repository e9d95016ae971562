#version 150 core
out vec4 colour;
uniform vec4 lineColour;

void main() { colour = lineColour; }
