#include "core/accumulate/sources/nearest_levels.h"

#include <algorithm>
#include <limits>

namespace noonmark {

namespace {

constexpr float none = std::numeric_limits<float>::infinity();
constexpr float farthest = std::numeric_limits<float>::max();  // beyond it: nothing
using UnsignedInts16 = std::uint32_t __attribute__((vector_size(64), may_alias));
constexpr Floats16 countingF{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr Ints16 counting{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// Where a band's levels lie in memory.
struct Levels {
    Line<float>* heightM;
    Line<std::int32_t>* building;
    std::size_t stride;  // lines from one level to the next
    int count;
};

// Each lane carries its occluder down the levels: what is farther than it goes on in its place, and it ends
// where the building was known already.
NOONMARK_EVERY_ISA void insert(const Levels& levels, int firstLine, int endLine,
                               const NearestLevels::Span& span) {
    const auto building = std::int32_t(span.building);
    const Floats16 nothing = none - Floats16{}, tooNear = farthest - Floats16{};
    const auto width = std::uint32_t(span.end - span.first);
    for (int line = firstLine; line < endLine; ++line) {
        const Ints16 column = counting + line * 16;
        const Floats16 height =
            float(span.heightM + line * 16 * span.slopeM) + countingF * float(span.slopeM);
        // Two conditions that choose the same are taken apart lane by lane (GCC 12): these choose
        // differently.
        Floats16 carried = UnsignedInts16(column - span.first) < width ? height : nothing;
        carried = height >= span.nearestM ? carried : tooNear;
        Ints16 carriedBuilding = building - Ints16{};
        for (int level = 0; level < levels.count; ++level) {
            auto& heights = reinterpret_cast<Floats16&>(
                levels.heightM[std::size_t(level) * levels.stride + std::size_t(line)]);
            auto& buildings = reinterpret_cast<Ints16&>(
                levels.building[std::size_t(level) * levels.stride + std::size_t(line)]);
            const Floats16 here = heights;
            const Ints16 hereBuilding = buildings;
            heights = carried <= here ? carried : here;
            buildings = carried <= here ? carriedBuilding : hereBuilding;
            carriedBuilding = carried <= here ? hereBuilding : carriedBuilding;
            carried = carried <= here ? here : carried;
            carried = hereBuilding == building ? nothing : carried;
        }
    }
}

NOONMARK_EVERY_ISA void copyFound(const float* heights, const std::int32_t* buildings, int count,
                                  float* heightM, std::uint32_t* building) {
    for (int i = 0; i < count; ++i) {
        const bool found = heights[i] < farthest;
        heightM[i] = found ? heights[i] : 0;
        building[i] = found ? std::uint32_t(buildings[i]) : 0;
    }
}

}  // namespace

NearestLevels::NearestLevels(int levels, int rows, int columns)
    : levels_(levels),
      rows_(rows),
      columns_(columns),
      linesPerRow_((columns + 15) / 16),
      heightM_(std::size_t(levels) * std::size_t(rows) * std::size_t(linesPerRow_)),
      building_(heightM_.size()) {}

void NearestLevels::clear() {
    for (Line<float>& line : heightM_) std::ranges::fill(line.values, none);
    std::ranges::fill(building_, Line<std::int32_t>{});
}

void NearestLevels::add(const Span& span) {
    const Levels levels{heightM_.data() + lineOf(0, span.row), building_.data() + lineOf(0, span.row),
                        std::size_t(rows_) * std::size_t(linesPerRow_), levels_};
    insert(levels, span.first / 16, (span.end + 15) / 16, span);
}

void NearestLevels::copyRow(int level, int row, float* heightM, std::uint32_t* building) const {
    const std::size_t line = lineOf(level, row);
    copyFound(heightM_[line].values, building_[line].values, columns_, heightM, building);
}

}  // namespace noonmark
