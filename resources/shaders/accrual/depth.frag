// Depth alone is drawn.
void main() {}
