#include "core/accumulate/horizon/raise_line.h"

#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

namespace {
constexpr float leastDistance = 1e-6F;  // a cell on a wall has a horizon above any sun
constexpr Ints16 counting{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
}  // namespace

NOONMARK_EVERY_ISA
void raiseLine(const WallOnLine& wall, const float* fractions, float* horizons) {
    const Floats16 none = Floats16{} + 0.0F, closest = none + leastDistance;
    for (int along = wall.first & ~15; along < wall.end; along += 16) {
        const Floats16 fraction = *reinterpret_cast<const Floats16*>(fractions + along);
        Floats16& horizon = *reinterpret_cast<Floats16*>(horizons + along);
        const Floats16 place = __builtin_convertvector(counting + along, Floats16);
        const Floats16 distance = place - (wall.along + wall.slope * fraction);
        const Floats16 slope = wall.rise / (distance > closest ? distance : closest);
        const Ints16 shaded =
            (distance > wall.nearest) & (fraction >= wall.lowQ) & (fraction < wall.highQ) & (slope > horizon);
        horizon = shaded ? slope : horizon;
    }
}

}  // namespace noonmark
