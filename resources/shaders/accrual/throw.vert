// Places a point of the city in the depth map of one step. The same code, and so the same bits, whether it draws
// all steps of an interval as instances of one draw, or each in a pass of its own.
layout(location = 0) in vec3 placed;  // foot on the maps' plane and height before it, metres

uniform int firstStep;        // of the instances
uniform vec2 shear[64];       // by step: metres against which a shadow moves, a metre of height
uniform mat3 clipFromPlane;   // third coordinate: q of the warp
uniform vec2 depthRange;      // lowest and highest height over q that depths tell apart

#ifndef LAYER_IN_VERTEX
out int layerOfVertex;
#endif

void main() {
    precise vec2 thrown = placed.xy - placed.z * shear[firstStep + gl_InstanceID];
    precise vec3 at = clipFromPlane * vec3(thrown, 1.0);
    // Depth over q is linear on the warped map, and that is what a depth buffer interpolates.
    precise float depth = (placed.z - depthRange.x * at.z) / (depthRange.y - depthRange.x);
    gl_Position = vec4(at.xy, 2.0 * depth - at.z, at.z);
#ifdef LAYER_IN_VERTEX
    gl_Layer = gl_InstanceID;
#else
    layerOfVertex = gl_InstanceID;
#endif
}
