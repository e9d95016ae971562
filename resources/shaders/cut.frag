#version 150 core
// Faces from behind: the inside of a building that the section box cuts, drawn as the solid that was cut.
out vec4 colour;

void main() { colour = vec4(0.36, 0.30, 0.42, 1.0); }
