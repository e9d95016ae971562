#include "core/engines/horizon/overhangs/overhang_intervals.h"

#include "core/simd/simd_lanes.h"

namespace noonmark {

namespace {

constexpr HorizonCode zenith = HorizonCode(steepnessLevels - 1 + int(noHorizon));

[[gnu::always_inline]] inline HorizonCode codeOfRise(float rise, float distance) {
    const float steepness = rise > 0 ? rise / (rise + distance) : 0;
    const int level = int(steepness * float(steepnessLevels));
    return rise > 0 ? HorizonCode(std::min(level, steepnessLevels - 1) + int(noHorizon)) : noHorizon;
}

// If the near side lies behind the cell, the cell is below or above the overhang; an overhang above it hides
// everything up to the zenith.
NOONMARK_EVERY_ISA
void findIntervals(const VisibleCells& seen, bool solid, HorizonCode* low, HorizonCode* high) {
    const int count = seen.count;
    for (int i = 0; i < count; ++i) {
        const float toNear = seen.toNear[i], toFar = seen.toFar[i], near = seen.nearRise[i],
                    far = seen.farRise[i];
        const float over = solid ? far : near * toFar - far * toNear;
        const HorizonCode behind = over > 0 ? zenith : noHorizon;
        const HorizonCode ahead = codeOfRise(near, toNear > 0 ? toNear : 1);
        const HorizonCode atNear = toNear > 0 ? ahead : behind, atFar = codeOfRise(far, toFar);
        low[i] = std::min(atNear, atFar);
        high[i] = std::max(atNear, atFar);
    }
}

}  // namespace

void OverhangIntervals::begin(const ViewingBlock& from, const BlockAxes& axes, HorizonCode lowest) {
    block_ = from;
    axes_ = axes;
    lowest_ = lowest;
    raised_.fill(0);
    apart_.clear();
}

void OverhangIntervals::look(const OverhangLayer& layer, std::span<const OverhangStrip> strips,
                             HorizonCode most) {
    seen_.count = strips_.count = 0;
    for (const OverhangStrip& strip : strips) {
        strips_.add(strip, axes_);
        if (strips_.count < StripLanes::most) continue;
        addVisibleCells(strips_, block_, axes_, most, seen_);
        strips_.count = 0;
    }
    if (strips_.count > 0) addVisibleCells(strips_, block_, axes_, most, seen_);
    if (seen_.count > 0) add(layer.solid);
}

void OverhangIntervals::add(bool solid) {
    findIntervals(seen_, solid, low_, high_);
    for (int i = 0; i < seen_.count; ++i) {
        const int cell = seen_.cell[i];
        if (high_[i] <= std::max(lowest_, block_.horizons.values[cell])) continue;
        if (joins(cell, low_[i]))
            raise(cell, low_[i], high_[i]);
        else
            apart_.push_back({cell, low_[i], high_[i]});
    }
}

void OverhangIntervals::raise(int cell, HorizonCode low, HorizonCode high) {
    HorizonCode& horizon = block_.horizons.values[cell];
    if (high <= horizon) return;
    std::uint64_t& word = raised_[std::size_t(cell) / 64];
    const std::uint64_t bit = std::uint64_t{1} << (unsigned(cell) % 64);
    HorizonCode& lowest = lows_[std::size_t(cell)];
    lowest = (word & bit) != 0 ? std::min(lowest, low) : low;
    word |= bit;
    horizon = high;
}

}  // namespace noonmark
