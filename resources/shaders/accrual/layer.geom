// Sends a triangle to its layer, where a vertex shader must not.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
in int layerOfVertex[];

void main() {
    for (int i = 0; i < 3; ++i) {
        gl_Layer = layerOfVertex[i];
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
