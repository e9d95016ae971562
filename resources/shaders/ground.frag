#version 150 core
#pragma include triangle.inc
#pragma include light.inc
#pragma include triangle_sun.inc
#pragma include earth.inc

void main() {
    vec3 normal = flatNormal();
    vec3 shown = earthColour(place, normal, length(eyeSpace), sunAt(place, normal));
    colour = vec4(withExplored(shown, place, normal), 1.0);
}
