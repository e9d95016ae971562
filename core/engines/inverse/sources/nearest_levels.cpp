#include "core/engines/inverse/sources/nearest_levels.h"

#include <algorithm>
#include <limits>

#include "core/simd/registers.h"

namespace noonmark {

namespace {

constexpr float none = std::numeric_limits<float>::infinity();
constexpr float farthest = std::numeric_limits<float>::max();  // larger heights mean no occluder

/// A block's levels in memory; those of one major position are contiguous.
struct Levels {
    Line<float>* heightM;
    Line<std::uint32_t>* building;
    int count;
};

// Inserts one occluder per lane, for as many lanes from `first` on as a register has. Each lane carries its
// occluder down the levels: it displaces a higher one, which is then carried on, and stops where its building
// is already in the list.
template <class Register>
[[gnu::always_inline]] inline void insertFrom(int first, const Levels& levels,
                                              const NearestLevels::Span& span,
                                              const NearestLevels::Facet& facet) {
    using Floats = FloatsOf<Register>;
    using Ints = IntsOf<Register>;
    const auto building = std::int32_t(facet.building);
    const Floats nothing = none - Floats{}, tooNear = farthest - Floats{};
    Ints lane;
    count<Register>(lane);
    lane += first;
    const Floats height = span.heightM + __builtin_convertvector(lane, Floats) * facet.perLaneM;
    // The compiler splits two conditions with the same choices into scalar operations (GCC 12), so these have
    // different choices.
    const Ints inside = (lane - span.first) | (span.end - 1 - lane);  // not negative inside the span
    Floats carried = inside >= 0 ? height : nothing;
    carried = height >= facet.nearestM ? carried : tooNear;
    Ints carriedBuilding = building - Ints{};
    const std::size_t line = std::size_t(span.major) * std::size_t(levels.count);
    for (int level = 0; level < levels.count; ++level) {
        auto& heights = reinterpret_cast<Floats&>(levels.heightM[line + std::size_t(level)].values[first]);
        auto& buildings = reinterpret_cast<Ints&>(levels.building[line + std::size_t(level)].values[first]);
        const Floats here = heights;
        const Ints hereBuilding = buildings;
        heights = carried <= here ? carried : here;
        buildings = carried <= here ? carriedBuilding : hereBuilding;
        carriedBuilding = carried <= here ? hereBuilding : carriedBuilding;
        carried = carried <= here ? here : carried;
        carried = hereBuilding == building ? nothing : carried;
    }
}

void insert(const Levels& levels, std::span<const NearestLevels::Span> spans,
            const NearestLevels::Facet& facet) {
    runWithWidestRegisters([=](auto registers) __attribute__((always_inline)) {
        using Register = decltype(registers);
        const Levels into = levels;
        const NearestLevels::Facet of = facet;
        for (const NearestLevels::Span& span : spans)
            for (int first = 0; first < Lanes::perBlock; first += lanesIn<Register>)
                if (first < span.end && first + lanesIn < Register >> span.first)
                    insertFrom<Register>(first, into, span, of);
    });
}

NOONMARK_EVERY_ISA void keepFound(Line<float>* heightM, Line<std::uint32_t>* building, std::size_t lines) {
    for (std::size_t i = 0; i < lines; ++i)
        for (int lane = 0; lane < Lanes::perBlock; ++lane) {
            const bool found = heightM[i].values[lane] < farthest;
            building[i].values[lane] = found ? building[i].values[lane] : LaneSources::nobody;
            heightM[i].values[lane] = found ? heightM[i].values[lane] : 0;
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
    insert(levels, spans, facet);
}

void NearestLevels::finish() {
    keepFound(&sources_.heightM[firstLine_], &sources_.building[firstLine_], lines_);
}

}  // namespace noonmark
