#version 150 core
#pragma include triangle.inc
#pragma include light.inc
#pragma include triangle_sun.inc
#pragma include body.inc
uniform vec3 baseColour;

void main() {
    vec3 normal = flatNormal();
    vec3 shown = bodyColour(baseColour, place, normal, length(eyeSpace), sunAt(place, normal));
    colour = vec4(withExplored(shown, place, normal), 1.0);
}
