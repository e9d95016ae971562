#include "core/accumulate/horizon/raise_line.h"

#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

namespace {

constexpr float leastDistance = 1e-6F;  // a cell on a wall has a horizon above any sun
constexpr Ints16 counting{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

[[gnu::always_inline]] inline void lowerTo(Floats16& values, const Ints16& order) {
    const Floats16 others = __builtin_shuffle(values, order);
    values = others < values ? others : values;
}

[[gnu::always_inline]] inline float lowestOf(const Floats16& values) {
    Floats16 low = values;
    for (int apart = 8; apart > 0; apart /= 2) lowerTo(low, counting ^ apart);
    return low[0];
}

[[gnu::always_inline]] inline void raise(const WallOnLine& wall, int along, const Floats16& fraction,
                                         Floats16& horizon) {
    const Floats16 closest = Floats16{} + leastDistance;
    const Floats16 place = __builtin_convertvector(counting + along, Floats16);
    const Floats16 distance = place - (wall.along + wall.slope * fraction);
    const Floats16 slope = wall.rise / (distance > closest ? distance : closest);
    const Ints16 shaded =
        (distance > wall.nearest) & (fraction >= wall.lowQ) & (fraction < wall.highQ) & (slope > horizon);
    horizon = shaded ? slope : horizon;
}

}  // namespace

NOONMARK_EVERY_ISA
void lowestOfSixteens(const float* horizons, std::span<float> lowest) {
    for (std::size_t i = 0; i < lowest.size(); ++i)
        lowest[i] = lowestOf(*reinterpret_cast<const Floats16*>(horizons + i * 16));
}

NOONMARK_EVERY_ISA
void raiseLine(const WallOnLine& wall, const float* fractions, float* horizons, float* lowest) {
    for (int sixteen = wall.first >> 4; sixteen < (wall.end + 15) >> 4; ++sixteen) {
        const int along = sixteen * 16;
        const float before = float(along) - wall.farthest;
        if (before > 0 && wall.rise <= lowest[sixteen] * before) continue;
        auto& horizon = *reinterpret_cast<Floats16*>(horizons + along);
        raise(wall, along, *reinterpret_cast<const Floats16*>(fractions + along), horizon);
        lowest[sixteen] = lowestOf(horizon);
    }
}

}  // namespace noonmark
