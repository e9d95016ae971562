// Tests every receiver against the maps of some steps and sets a bit for each step in shadow.
layout(local_size_x = 64) in;

struct Receiver {
    vec4 place;   // foot on the maps' plane, height before it, metres
    vec4 normal;  // in the frame's axes
};
layout(std430, binding = 0) readonly buffer Receivers { Receiver receivers[]; };
layout(std430, binding = 1) buffer Masks { uvec2 masks[]; };

uniform sampler2DArray maps;
uniform uint receiverCount;
uniform int firstStep;        // of the maps' layers
uniform int steps;            // layers to test
uniform vec2 shear[64];
uniform vec3 sun[64];         // towards it, in the frame's axes
uniform mat3 texelFromPlane;
uniform vec3 perQ;            // 1 / q of a texel's centre, from (column, row, 1)
uniform vec2 depthRange;
uniform float bias;           // metres
uniform float slopeBias;      // metres of a texel where q is 1 x the setting

bool shaded(Receiver receiver, int layer) {
    int step = firstStep + layer;
    float facing = dot(receiver.normal.xyz, sun[step]);
    if (facing <= 0.0) return true;
    vec3 at = texelFromPlane * vec3(receiver.place.xy - receiver.place.z * shear[step], 1.0);
    vec2 last = vec2(textureSize(maps, 0).xy - 1);
    ivec2 texel = ivec2(clamp(at.xy / at.z + 0.5, vec2(0.0), last));
    float slope = slopeBias * sun[step].z * (abs(receiver.normal.x) + abs(receiver.normal.y)) / max(facing, 1e-6);
    float height = (receiver.place.z + bias + slope * at.z) * dot(perQ, vec3(texel, 1.0));
    float depth = (height - depthRange.x) / (depthRange.y - depthRange.x);
    return texelFetch(maps, ivec3(texel, layer), 0).r > depth;
}

void main() {
    uint index = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 64u;
    if (index >= receiverCount) return;
    Receiver receiver = receivers[index];
    uvec2 mask = firstStep == 0 ? uvec2(0u) : masks[index];
    for (int layer = 0; layer < steps; ++layer) {
        int step = firstStep + layer;
        if (!shaded(receiver, layer)) continue;
        if (step < 32) mask.x |= 1u << uint(step);
        else mask.y |= 1u << uint(step - 32);
    }
    masks[index] = mask;
}
