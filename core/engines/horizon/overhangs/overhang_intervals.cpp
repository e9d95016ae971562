#include "core/engines/horizon/overhangs/overhang_intervals.h"

namespace noonmark {

void OverhangIntervals::begin(const ViewingBlock& from, const BlockAxes& axes, HorizonCode lowest) {
    block_ = from;
    axes_ = axes;
    lowest_ = lowest;
    raised_.fill(0);
    apart_.clear();
}

void OverhangIntervals::look(const OverhangLayer& layer, std::span<const OverhangStrip> strips,
                             HorizonCode maximum) {
    seen_.count = strips_.count = 0;
    for (const OverhangStrip& strip : strips) {
        strips_.add(strip, axes_);
        if (strips_.count < StripLanes::maximum) continue;
        addVisibleCells(strips_, block_, axes_, maximum, seen_);
        strips_.count = 0;
    }
    if (strips_.count > 0) addVisibleCells(strips_, block_, axes_, maximum, seen_);
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
