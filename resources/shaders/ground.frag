#version 150 core
// The field as a picture laid over the ground, or what a camera saw of it: what neither covers keeps the ground's own colour.
// Their colours are shown as they are in the legend, without light or haze.
in vec3 place;
in vec3 eyeSpace;
out vec4 colour;
uniform mat4 inverseViewMatrix;
uniform vec3 groundColour;
uniform sampler2D map;  // streets, parks and water, or an aerial picture: premultiplied colour
uniform vec4 mapBox;    // west, south, width, height in metres; width 0: no map
uniform vec3 haze;
uniform float hazeDistance;
#pragma include explored.inc
#pragma include pictured.inc
#pragma include sunlit.inc

// Software drawing looks textures up in branches not taken, too: far outside, the filter would run for minutes.
vec3 mappedGround() {
    vec2 within = (place.xy - mapBox.xy) / max(mapBox.zw, vec2(1.0));
    vec2 inside = clamp(within, 0.0, 1.0);
    vec4 drawn = texture(map, inside);
    if (mapBox.z <= 0.0 || within != inside) return groundColour;
    return drawn.rgb + groundColour * (1.0 - drawn.a);
}

void main() {
    vec3 normal = mat3(inverseViewMatrix) * normalize(cross(dFdx(eyeSpace), dFdy(eyeSpace)));
    float light = 0.72 + 0.28 * clamp(dot(normal, normalize(vec3(-0.55, -0.70, 0.62))) / 0.57, 0.0, 1.3);
    vec3 tint = sunShown > 0.0 ? mix(vec3(0.52, 0.55, 0.63), vec3(1.06, 1.04, 1.0), sunlit(place, normal)) : vec3(light);
    vec3 ground = mix(mappedGround() * tint, haze, smoothstep(0.35, 1.0, length(eyeSpace) / hazeDistance));
    vec4 field = pictured(place);
    vec4 seen = explored(place, normal);
    vec3 shown = field.rgb + ground * (1.0 - field.a);
    colour = vec4(mix(shown, seen.rgb, seen.a), 1.0);
}
