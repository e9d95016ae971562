#version 150 core
// Flat faces: the normal comes from how the position changes between pixels, in eye space, where numbers are small near the eye.
in vec3 eyeSpace;
in vec3 place;
out vec4 colour;
uniform mat4 inverseViewMatrix;
uniform vec3 baseColour;
uniform vec3 haze;
uniform float hazeDistance;
#pragma include explored.inc
#pragma include pictured.inc
#pragma include sunlit.inc

void main() {
    vec3 normal = mat3(inverseViewMatrix) * normalize(cross(dFdx(eyeSpace), dFdy(eyeSpace)));
    float sky = 0.5 + 0.5 * normal.z;
    vec3 lit;
    if (sunShown > 0.0) {
        float sun = sunlit(place, normal) * (0.45 + 0.55 * max(dot(normal, sunDirection), 0.0));
        lit = baseColour * (vec3(0.40, 0.43, 0.50) + sky * vec3(0.13, 0.135, 0.14) + sun * vec3(0.50, 0.46, 0.37));
    } else {
        float sun = max(dot(normal, normalize(vec3(-0.55, -0.70, 0.62))), 0.0);
        lit = baseColour * (vec3(0.59, 0.615, 0.66) + sky * vec3(0.23, 0.225, 0.215) + sun * vec3(0.31, 0.29, 0.255));
    }
    vec3 bare = mix(lit, haze, 0.75 * smoothstep(0.4, 1.0, length(eyeSpace) / hazeDistance));
    vec4 roof = pictured(place) * step(0.3, normal.z);  // walls have no receivers
    vec3 shown = roof.rgb + bare * (1.0 - roof.a);
    vec4 seen = explored(place, normal);
    colour = vec4(mix(shown, seen.rgb, seen.a), 1.0);
}
