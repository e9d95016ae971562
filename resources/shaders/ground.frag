#version 150 core
// The field as a picture laid over the ground, or what a camera saw of it: what neither covers keeps the ground's own colour.
// Their colours are shown as they are in the legend, without light or haze.
in vec3 place;
in vec3 eyeSpace;
out vec4 colour;
uniform mat4 inverseViewMatrix;
uniform sampler2D picture;
uniform vec4 pictureBox;  // west, south, width, height in metres; width 0: no picture
uniform vec3 groundColour;
uniform vec3 haze;
uniform float hazeDistance;
uniform float pictureSoFar;  // 1: the picture is of a part of the study
#pragma include explored.inc

vec4 pictured() {
    vec2 within = (place.xy - pictureBox.xy) / max(pictureBox.zw, vec2(1e-6));
    vec4 field = texture(picture, within);
    bool covered = pictureBox.z > 0.0 && all(greaterThanEqual(within, vec2(0.0))) && all(lessThan(within, vec2(1.0)));
    if (!covered) return vec4(0.0);
    return vec4(mix(field.rgb, striped(field.rgb, pictureSoFar), field.a), field.a);
}

void main() {
    vec3 normal = mat3(inverseViewMatrix) * normalize(cross(dFdx(eyeSpace), dFdy(eyeSpace)));
    float light = 0.72 + 0.28 * clamp(dot(normal, normalize(vec3(-0.55, -0.70, 0.62))) / 0.57, 0.0, 1.3);
    vec3 ground = mix(groundColour * light, haze, smoothstep(0.35, 1.0, length(eyeSpace) / hazeDistance));
    vec4 field = pictured();
    vec4 seen = explored(place, normal);
    vec3 shown = field.rgb + ground * (1.0 - field.a);
    colour = vec4(mix(shown, seen.rgb, seen.a), 1.0);
}
