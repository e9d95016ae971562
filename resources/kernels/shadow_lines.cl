// Draws the shadow lines of one lane of cells a work item. A lane's cells belong to no other lane, so plain reads and
// writes will do. The same algorithm, to the bit, as core/accumulate/shadow_lines.cpp and source_runs.h; the host side
// and the meaning of every argument: core/accumulate/shadow_lines_opencl.cpp.
#pragma OPENCL FP_CONTRACT OFF

#define TABLE_SIZE 4096
#define MAX_LEVELS 8
#define GOES_ON -1
#define REACH (0.5f - 1.0f / 6)  // of a run's end beyond its cell's centre

// Neighbouring cells whose occluding points lie next to each other on one building; cells are counted the way the
// shadow moves.
typedef struct {
    int first;
    int last;
    float first_m;
    float last_m;
    uint building;
} run_t;

// One lane and what is drawn into it.
typedef struct {
    global ulong* masks;
    constant ulong* before;
    global const int* bend;
    int start;
    int columns;
    int along_x;
    int reversed;
    int2 part;
    float cells_per_metre;
    float steepest_m;
} lane_t;

inline size_t cell_at(const lane_t* lane, int at) {
    const int major = lane->reversed ? lane->part.y - 1 - at : lane->part.x + at;
    const int minor = lane->start + lane->bend[major];
    return lane->along_x ? (size_t)minor * lane->columns + major : (size_t)major * lane->columns + minor;
}

inline bool same_surface(const lane_t* lane, float before_m, float after_m) {
    const float higher = after_m - before_m;
    return higher <= lane->steepest_m && higher >= -lane->steepest_m;
}

inline bool folds(const lane_t* lane, float before_m, float after_m) {
    return (after_m - before_m) * lane->cells_per_metre < -1.5f;
}

inline ulong steps_at(const lane_t* lane, float per_cell, float ahead, int cell) {
    const float start = ahead * per_cell;
    const float way = (float)cell * per_cell;
    const float at = start + way;
    return lane->before[(int)((at < 0 ? -1 : at < TABLE_SIZE + 1 ? at : TABLE_SIZE + 1) + 1)];
}

inline int end_of(int cell, float length, int cells) {
    return min(cell + 1 + (int)(min(length, 1e6f) + 0.5f), cells);
}

void shade(const lane_t* lane, int cell, ulong steps) {
    const size_t target = cell_at(lane, cell);
    const ulong now = lane->masks[target];
    if ((now | steps) != now) lane->masks[target] = now | steps;
}

void draw_run(const lane_t* lane, const run_t* run) {
    const int cells = lane->part.y - lane->part.x;
    const float first_length = run->first_m * lane->cells_per_metre, last_length = run->last_m * lane->cells_per_metre;
    const float per_first = (float)TABLE_SIZE / fmax(first_length, 1e-6f);
    const float per_last = (float)TABLE_SIZE / fmax(last_length, 1e-6f);
    const bool folded = run->first < run->last && folds(lane, run->first_m, run->last_m);
    const float width = (float)(run->last - run->first);
    const int end = max(end_of(run->last, last_length, cells), folded ? end_of(run->first, first_length, cells) : 0);
    for (int i = 0; i < end - run->first; ++i) {
        ulong steps = steps_at(lane, per_first, REACH, i) & ~steps_at(lane, per_last, -width - REACH, i);
        if (folded) steps |= steps_at(lane, per_last, REACH - width, i) & ~steps_at(lane, per_first, -REACH, i);
        shade(lane, run->first + i, steps);
    }
}

kernel void draw_lanes(global const float* height_m,  // levels x cells, level-major; 0 = no occluder
                       global const uint* building,   // the same shape
                       int levels,
                       int columns,
                       int rows,
                       int along_x,                // 1: lanes run along x
                       int first_lane,
                       global const int* bend,     // by major position
                       global const int2* stretch, // by lane: first and end major position
                       float cells_per_metre,      // > 0
                       float steepest_m,
                       int reversed,               // 1: shadows move against the lane
                       constant ulong* before,     // TABLE_SIZE + 3: bits of the steps up to a share of the line
                       global ulong* masks)        // cells; ORed into
{
    const int number = get_global_id(0);
    const lane_t lane = {masks,   before,   bend,            number + first_lane, columns,
                         along_x, reversed, stretch[number], cells_per_metre,     steepest_m};
    const size_t size = (size_t)columns * (size_t)rows;
    const int cells = lane.part.y - lane.part.x;
    run_t open[2][MAX_LEVELS];
    int count = 0;

    for (int cell = 0; cell <= cells; ++cell) {
        run_t* old = open[cell & 1];
        run_t* next = open[1 - (cell & 1)];
        int next_count = 0;
        for (int level = 0; cell < cells && level < levels; ++level) {
            const size_t place = level * size + cell_at(&lane, cell);
            const float height = height_m[place];
            if (height <= 0) break;
            run_t run = {cell, cell, height, height, building[place]};
            for (int i = 0; i < count; ++i) {
                if (old[i].last == GOES_ON || old[i].building != run.building ||
                    !same_surface(&lane, old[i].last_m, height))
                    continue;
                if (folds(&lane, old[i].last_m, height)) {
                    const run_t fold = {cell - 1, cell, old[i].last_m, height, run.building};
                    draw_run(&lane, &fold);
                    break;
                }
                run.first = old[i].first;
                run.first_m = old[i].first_m;
                old[i].last = GOES_ON;
                break;
            }
            next[next_count++] = run;
        }
        for (int i = 0; i < count; ++i)
            if (old[i].last != GOES_ON) draw_run(&lane, &old[i]);
        count = next_count;
    }
}
