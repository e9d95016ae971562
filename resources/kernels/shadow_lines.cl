// Draws the shadow lines of one lane of places with ITEMS neighbouring work items: each finds all runs of the lane and draws every
// ITEMS-th place, so a mask belongs to one work item and plain reads and writes will do. The same algorithm, to the bit, as
// core/lab/inverse/shadow_lines.cpp and lanes.h; the host side and the meaning of every argument:
// core/lab/inverse/shadow_lines_opencl.cpp, lanes.h and lanes.h.
#pragma OPENCL FP_CONTRACT OFF

#define TABLE_SIZE 4096
#define MAX_LEVELS 8
#define LANES 16  // of a block
#ifndef ITEMS
#define ITEMS 1  // that share a lane; a power of two
#endif
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
    int places;
    int reversed;
    int item;  // of the lane: draws the cells whose number has this remainder by ITEMS
    float cells_per_metre;
    float steepest_m;
} lane_t;

inline int major_at(const lane_t* lane, int at) { return lane->reversed ? lane->places - 1 - at : at; }

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
    const int target = major_at(lane, cell);
    const ulong now = lane->masks[target];
    if ((now | steps) != now) lane->masks[target] = now | steps;
}

void draw_run(const lane_t* lane, const run_t* run) {
    const int cells = lane->places;
    const float first_length = run->first_m * lane->cells_per_metre, last_length = run->last_m * lane->cells_per_metre;
    const float per_first = (float)TABLE_SIZE / fmax(first_length, 1e-6f);
    const float per_last = (float)TABLE_SIZE / fmax(last_length, 1e-6f);
    const bool folded = run->first < run->last && folds(lane, run->first_m, run->last_m);
    const float width = (float)(run->last - run->first);
    const int end = max(end_of(run->last, last_length, cells), folded ? end_of(run->first, first_length, cells) : 0);
    for (int i = (lane->item - run->first) & (ITEMS - 1); i < end - run->first; i += ITEMS) {
        ulong steps = steps_at(lane, per_first, REACH, i) & ~steps_at(lane, per_last, -width - REACH, i);
        if (folded) steps |= steps_at(lane, per_last, REACH - width, i) & ~steps_at(lane, per_first, -REACH, i);
        shade(lane, run->first + i, steps);
    }
}

kernel void draw_lanes(global const float* height_m,  // blocks x places x levels x lanes of a block; 0 = no occluder
                       global const uint* building,   // the same shape
                       int levels,
                       int places,                 // of a lane
                       float cells_per_metre,      // > 0
                       float steepest_m,
                       int reversed,               // 1: shadows move towards a lane's first place
                       constant ulong* before,     // TABLE_SIZE + 3: bits of the steps up to a share of the line
                       global ulong* masks)        // lanes x places; ORed into
{
    const size_t number = get_global_id(0) / ITEMS;
    const int item = (int)(get_global_id(0) % ITEMS);
    const lane_t lane = {masks + number * places, before, places, reversed, item, cells_per_metre, steepest_m};
    const size_t first_line = number / LANES * places * levels;
    run_t open[2][MAX_LEVELS];
    int count = 0;

    for (int cell = 0; cell <= places; ++cell) {
        run_t* old = open[cell & 1];
        run_t* next = open[1 - (cell & 1)];
        int next_count = 0;
        for (int level = 0; cell < places && level < levels; ++level) {
            const size_t place = (first_line + (size_t)(major_at(&lane, cell) * levels + level)) * LANES + number % LANES;
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
