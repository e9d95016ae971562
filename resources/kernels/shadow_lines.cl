// Draws the shadow lines of one lane of cells a work item. A lane's cells belong to no other lane, so plain reads and
// writes will do. The host side and the meaning of every argument: core/accumulate/shadow_lines_opencl.cpp.

#define TABLE_SIZE 4096

inline int entry_of(float share) { return (int)min(share, (float)(TABLE_SIZE + 1)); }

kernel void draw_lanes(global const float* height_m,      // levels x cells, level-major; 0 = no occluder
                       int levels,
                       int columns,
                       int rows,
                       int along_x,                         // 1: lanes run along x
                       int first_lane,
                       global const int* bend,              // by major position
                       global const int2* stretch,          // by lane: first and end major position
                       float cells_per_metre,               // > 0
                       int sign,                            // +1 or -1: which way along the lane
                       constant const uchar* first_beyond,  // TABLE_SIZE + 2
                       constant const uchar* nearest,       // TABLE_SIZE + 2
                       constant const ulong* up_to,         // steps + 1
                       global ulong* masks)                 // cells; ORed into
{
    const int lane = get_global_id(0);
    const int start = lane + first_lane;
    const int2 part = stretch[lane];
    const size_t cells = (size_t)columns * (size_t)rows;

    for (int major = part.x; major < part.y; ++major) {
        const int minor = start + bend[major];
        const size_t cell = along_x ? (size_t)minor * columns + major : (size_t)major * columns + minor;
        for (int level = 0; level < levels; ++level) {
            const float height = height_m[level * cells + cell];
            if (height <= 0) break;
            const float length = height * cells_per_metre;
            const int room = sign > 0 ? part.y - 1 - major : major - part.x;
            const int last = (int)min(length + 0.5f, (float)room);
            const float scale = (float)TABLE_SIZE / fmax(length, 1e-6f);
            int from = 0;
            for (int k = 0; k <= last; ++k) {
                const int to = first_beyond[entry_of(((float)k + 0.5f) * scale)];
                const int near = nearest[entry_of((float)k * scale)];
                const ulong steps = from < to ? up_to[to] & ~up_to[from] : up_to[near + 1] & ~up_to[near];
                const int at = major + sign * k;
                const int across = start + bend[at];
                const size_t target = along_x ? (size_t)across * columns + at : (size_t)at * columns + across;
                const ulong now = masks[target];
                if ((now | steps) != now) masks[target] = now | steps;
                from = to;
            }
        }
    }
}
