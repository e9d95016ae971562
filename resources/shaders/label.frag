#version 150 core
in vec2 at;
out vec4 colour;
uniform sampler2D names;

void main() { colour = texture(names, at); }
