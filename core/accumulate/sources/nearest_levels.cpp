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

/// Where a block's levels lie in memory: those of a major position one after the other.
struct Levels {
    Line<float>* heightM;
    Line<std::uint32_t>* building;
    int count;
};

// Each lane carries its occluder down the levels: what is farther than it goes on in its place, and it ends
// where the building was known already.
NOONMARK_EVERY_ISA void insert(const Levels& levels, const NearestLevels::Span* spans, std::size_t spanCount,
                               const NearestLevels::Facet& facet) {
    const auto building = std::int32_t(facet.building);
    const Floats16 nothing = none - Floats16{}, tooNear = farthest - Floats16{};
    const Floats16 slope = countingF * facet.perLaneM;
    for (std::size_t i = 0; i < spanCount; ++i) {
        const NearestLevels::Span& span = spans[i];
        const auto width = std::uint32_t(span.end - span.first);
        const Floats16 height = span.heightM + slope;
        // Two conditions that choose the same are taken apart lane by lane (GCC 12): these choose
        // differently.
        Floats16 carried = UnsignedInts16(counting - span.first) < width ? height : nothing;
        carried = height >= facet.nearestM ? carried : tooNear;
        Ints16 carriedBuilding = building - Ints16{};
        const std::size_t line = std::size_t(span.major) * std::size_t(levels.count);
        for (int level = 0; level < levels.count; ++level) {
            auto& heights = reinterpret_cast<Floats16&>(levels.heightM[line + std::size_t(level)]);
            auto& buildings = reinterpret_cast<Ints16&>(levels.building[line + std::size_t(level)]);
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

NOONMARK_EVERY_ISA void keepFound(Line<float>* heightM, Line<std::uint32_t>* building, std::size_t lines) {
    const Floats16 zero{};
    const Ints16 nobody = std::int32_t(LaneSources::nobody) - Ints16{};
    for (std::size_t i = 0; i < lines; ++i) {
        auto& heights = reinterpret_cast<Floats16&>(heightM[i]);
        auto& buildings = reinterpret_cast<Ints16&>(building[i]);
        buildings = heights < farthest ? buildings : nobody;
        heights = heights < farthest ? heights : zero;
    }
}

}  // namespace

NearestLevels::NearestLevels(LaneSources& sources, int into)
    : sources_(sources),
      firstLine_(sources.line(into, 0)),
      lines_(std::size_t(sources.majors) * std::size_t(sources.levels)) {
    Line<float> unknown;
    std::ranges::fill(unknown.values, none);
    std::fill_n(sources_.heightM.begin() + std::ptrdiff_t(firstLine_), lines_, unknown);
    std::fill_n(sources_.building.begin() + std::ptrdiff_t(firstLine_), lines_, Line<std::uint32_t>{});
}

void NearestLevels::add(std::span<const Span> spans, const Facet& facet) {
    const Levels levels{&sources_.heightM[firstLine_], &sources_.building[firstLine_], sources_.levels};
    insert(levels, spans.data(), spans.size(), facet);
}

void NearestLevels::finish() {
    keepFound(&sources_.heightM[firstLine_], &sources_.building[firstLine_], lines_);
}

}  // namespace noonmark
