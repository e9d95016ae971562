#version 150 core
// The field as a picture laid over the ground, or what a camera saw of it: what neither covers keeps the ground's own colour.
// Their colours are shown as they are in the legend, without light or haze.
in vec3 place;
in vec3 eyeSpace;
out vec4 colour;
uniform mat4 inverseViewMatrix;
uniform vec3 groundColour;
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
#ifdef MAP
uniform sampler2D map;  // streets, parks and water: premultiplied colour
uniform vec4 mapBox;    // west, south, width, height in metres

// Software drawing looks textures up in branches not taken, too: far outside, the filter would run for minutes.
vec3 mappedGround() {
    vec2 within = (place.xy - mapBox.xy) / max(mapBox.zw, vec2(1.0));
    vec2 inside = clamp(within, 0.0, 1.0);
    vec4 drawn = texture(map, inside);
    if (within != inside) return groundColour;
    return drawn.rgb + groundColour * (1.0 - drawn.a);
}
#endif

void main() {
    vec3 normal = mat3(inverseViewMatrix) * normalize(cross(dFdx(eyeSpace), dFdy(eyeSpace)));
#ifdef SUNLIT
    vec3 tint = mix(vec3(0.52, 0.55, 0.63), vec3(1.06, 1.04, 1.0), sunlit(place, normal));
#else
    vec3 tint = vec3(0.72 + 0.28 * clamp(dot(normal, normalize(vec3(-0.55, -0.70, 0.62))) / 0.57, 0.0, 1.3));
#endif
#ifdef MAP
    vec3 bare = mappedGround();
#else
    vec3 bare = groundColour;
#endif
    vec3 shown = mix(bare * tint, haze, smoothstep(0.35, 1.0, length(eyeSpace) / hazeDistance));
#ifdef PICTURE
    vec4 field = pictured(place);
    shown = field.rgb + shown * (1.0 - field.a);
#endif
#ifdef EXPLORED
    vec4 seen = explored(place, normal);
    shown = mix(shown, seen.rgb, seen.a);
#endif
    colour = vec4(shown, 1.0);
}
