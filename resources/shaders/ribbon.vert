#version 150 core
// A line of constant width in pixels: each end is doubled, and pushed to its side of the line on the screen.
in vec3 vertexPosition;
in vec3 otherEnd;
in float side;
uniform mat4 mvp;
uniform vec2 viewSize;
uniform float widthPx;
#pragma include clip.inc

vec4 inFrontOfEye(vec4 point, vec4 other) {
    const float least = 0.01;
    if (point.w >= least || other.w <= least) return point;
    return mix(point, other, (least - point.w) / (other.w - point.w));
}

void main() {
#ifdef UNCLIPPED
    clipNothing();
#else
    clip(vertexPosition);
#endif
    vec4 here = mvp * vec4(vertexPosition, 1.0);
    vec4 there = mvp * vec4(otherEnd, 1.0);
    here = inFrontOfEye(here, there);
    there = inFrontOfEye(there, here);
    vec2 along = (there.xy / there.w - here.xy / here.w) * viewSize;
    vec2 across = length(along) > 0.0 ? normalize(vec2(-along.y, along.x)) : vec2(0.0);
    here.xy += across * side * widthPx / viewSize * here.w;
    gl_Position = here;
#ifdef LIFTED
    gl_Position.z -= 0.0003 * gl_Position.w;
#endif
}
