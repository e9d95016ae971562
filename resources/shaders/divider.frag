#version 150 core
// The line between two sides of the view.
out vec4 colour;

void main() { colour = vec4(0.16, 0.18, 0.22, 0.9); }
