#version 150 core
// Flat faces: the normal comes from how the position changes between pixels, in eye space, where numbers are small near the eye.
in vec3 eyeSpace;
in vec3 place;
out vec4 colour;
uniform mat4 inverseViewMatrix;
uniform vec3 baseColour;
uniform vec3 haze;
uniform float hazeDistance;
#pragma include striped.inc
#ifdef EXPLORED
#pragma include explored.inc
#endif
#ifdef PICTURE
#pragma include pictured.inc
#endif
#ifdef SUNLIT
#pragma include sunlit.inc
#endif

void main() {
    vec3 normal = mat3(inverseViewMatrix) * normalize(cross(dFdx(eyeSpace), dFdy(eyeSpace)));
    float sky = 0.5 + 0.5 * normal.z;
    vec3 lit;
#ifdef SUNLIT
    float sun = sunlit(place, normal) * (0.45 + 0.55 * max(dot(normal, sunDirection), 0.0));
    lit = baseColour * (vec3(0.40, 0.43, 0.50) + sky * vec3(0.13, 0.135, 0.14) + sun * vec3(0.50, 0.46, 0.37));
#else
    float sun = max(dot(normal, normalize(vec3(-0.55, -0.70, 0.62))), 0.0);
    lit = baseColour * (vec3(0.59, 0.615, 0.66) + sky * vec3(0.23, 0.225, 0.215) + sun * vec3(0.31, 0.29, 0.255));
#endif
    vec3 shown = mix(lit, haze, 0.75 * smoothstep(0.4, 1.0, length(eyeSpace) / hazeDistance));
#ifdef PICTURE
    vec4 roof = pictured(place) * step(0.3, normal.z);  // walls have no receivers
    shown = roof.rgb + shown * (1.0 - roof.a);
#endif
#ifdef EXPLORED
    vec4 seen = explored(place, normal);
    shown = mix(shown, seen.rgb, seen.a);
#endif
    colour = vec4(shown, 1.0);
}
