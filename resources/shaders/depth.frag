#version 150 core
// Depth alone: colours are drawn by another pass.
void main() {}
