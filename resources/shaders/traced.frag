#version 330 core
// Colours what rays found at each pixel, and writes its depth, so that triangles can be drawn among it.
out vec4 colour;
uniform sampler2D traced;     // row 0 is the top; x: depth along the camera's forward direction in metres, y: bits of TracedPixel
uniform vec3 tracedEye;
uniform vec3 tracedForward;
uniform vec3 tracedRight;     // one pixel further at a depth of one metre, or at any depth in a parallel projection
uniform vec3 tracedUp;
uniform float tracedParallel;  // 1: parallel projection
uniform float tracedLeft;      // column of the window where the picture begins
uniform float tracedSpacing;   // pixels a side of each pixel of `traced`: more than 1 while the camera moves
uniform vec3 edgeColour;
uniform vec2 tracedClip;  // depth in the depth buffer: x + y / depth, in a parallel projection x + y * depth

// A texture over `box`, as coarse as its distance asks for. One texel: filters cost a processor most of a picture's time.
vec4 lookUp(sampler2D picture, vec2 within, vec4 box, vec3 at) {
    ivec2 size = textureSize(picture, 0);
    float pixelM = length(tracedUp) * mix(dot(at - tracedEye, tracedForward), 1.0, tracedParallel);
    float coarser = log2(max(pixelM * float(size.x) / max(box.z, 1e-6), 1.0));
    int level = int(min(coarser, floor(log2(float(max(size.x, size.y))))));
    ivec2 texels = max(size >> level, ivec2(1));
    return texelFetch(picture, min(ivec2(within * vec2(texels)), texels - 1), level);
}
#pragma include light.inc
#pragma include sky.inc
#pragma include body.inc
#pragma include earth.inc
uniform vec3 baseColour;
uniform vec3 proposalColour;
uniform vec3 evergreenColour;
uniform vec3 leafyColour;
uniform vec3 trunkColour;
uniform vec3 branchColour;

void main() {
    ivec2 size = textureSize(traced, 0);
    vec2 pixel = (gl_FragCoord.xy - vec2(tracedLeft, 0.0)) / tracedSpacing;
    vec2 seen = texelFetch(traced, clamp(ivec2(int(pixel.x), size.y - 1 - int(pixel.y)), ivec2(0), size - 1), 0).xy;
    int bits = floatBitsToInt(seen.y);
    int kind = bits >> 24 & 3;
    bool behindBareCrown = seen.x < 0.0;
    seen.x = abs(seen.x);
    vec2 aside = pixel - 0.5 * vec2(size);
    vec3 across = aside.x * tracedRight + aside.y * tracedUp;
    vec3 fromEye = seen.x * tracedForward + (tracedParallel > 0.0 ? 1.0 : seen.x) * across;
    vec3 at = tracedEye + fromEye;
    vec3 normal = vec3(bits & 255, bits >> 8 & 255, bits >> 16 & 255) / 127.0 - 1.0;
    float distanceToEye = length(fromEye);
    float sun = float(bits >> 27 & 1);
    if ((bits >> 29 & 1) == 1) sun = mix(0.25, 0.7, sun);  // in the shade of crowns: dense, or of bare ones
    vec3 base = (bits >> 28 & 1) == 1 ? proposalColour : baseColour;
    if (bits < 0) {
        base = kind == 0 ? evergreenColour : kind == 1 ? leafyColour : trunkColour;
        kind = 2;
    }
    vec3 shown = kind == 1 ? earthColour(at, normal, distanceToEye, sun) : bodyColour(base, at, normal, distanceToEye, sun);
    shown = withExplored(shown, at, normal);
    if (kind == 3) shown = vec3(0.36, 0.30, 0.42);  // as cut.frag
    // As edge.frag: far edges fade.
    float edge = float(bits >> 26 & 1) * 0.42 * (1.0 - smoothstep(0.15, 0.8, distanceToEye / hazeDistance));
    vec3 sky = skyColour(normalize(tracedForward + across));
    vec3 clear = kind == 0 ? sky : mix(shown, edgeColour, edge);
    colour = vec4(behindBareCrown ? mix(clear, branchColour, 0.35) : clear, 1.0);
    gl_FragDepth = kind == 0 ? 1.0 : tracedClip.x + tracedClip.y * (tracedParallel > 0.0 ? seen.x : 1.0 / seen.x);
}
