#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lab/inverse/sources/nearest_levels_hwy.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <limits>

#include "core/lab/inverse/sources/projected_source_finder.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

using D = LanesUpTo<float, Lanes::perBlock>;
using DU = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;
constexpr D d;
constexpr DU du;
constexpr int lanes = int(hn::MaxLanes(d));
constexpr float none = std::numeric_limits<float>::infinity();
constexpr float farthest = std::numeric_limits<float>::max();  // larger heights mean no occluder

// Inserts one occluder per lane, for a vector of lanes from `first` on. Each lane carries its occluder down
// the levels: it displaces a higher one, which is then carried on, and stops where its building is already in
// the list.
HWY_INLINE void insertFrom(int first, const BlockLevels& levels, const NearestLevels::Span& span,
                           const NearestLevels::Facet& facet) {
    const hn::RebindToSigned<D> di;
    const auto building = hn::Set(du, facet.building);
    const auto lane = hn::Iota(di, first);
    const V nothing = hn::Set(d, none),
            height = hn::Add(hn::Set(d, span.heightM),
                             hn::Mul(hn::ConvertTo(d, lane), hn::Set(d, facet.perLaneM)));
    const auto inside =
        hn::And(hn::Gt(lane, hn::Set(di, span.first - 1)), hn::Lt(lane, hn::Set(di, span.end)));
    V carried = hn::IfThenElse(hn::RebindMask(d, inside), height, nothing);
    carried = hn::IfThenElse(hn::Ge(height, hn::Set(d, facet.nearestM)), carried, hn::Set(d, farthest));
    auto carriedBuilding = building;
    const std::size_t line = std::size_t(span.major) * std::size_t(levels.count);
    for (std::size_t i = line; i < line + std::size_t(levels.count); ++i) {
        float* const heights = levels.heightM[i].values + first;
        std::uint32_t* const buildings = levels.building[i].values + first;
        const V here = hn::Load(d, heights);
        const auto hereBuilding = hn::Load(du, buildings);
        const auto nearer = hn::Le(carried, here);
        const auto nearerBuilding = hn::RebindMask(du, nearer);
        hn::Store(hn::IfThenElse(nearer, carried, here), d, heights);
        hn::Store(hn::IfThenElse(nearerBuilding, carriedBuilding, hereBuilding), du, buildings);
        carriedBuilding = hn::IfThenElse(nearerBuilding, hereBuilding, carriedBuilding);
        carried = hn::IfThenElse(nearer, here, carried);
        carried = hn::IfThenElse(hn::RebindMask(d, hn::Eq(hereBuilding, building)), nothing, carried);
    }
}

}  // namespace

void insertSpans(const BlockLevels& levels, std::span<const NearestLevels::Span> spans,
                 const NearestLevels::Facet& facet) {
    for (const NearestLevels::Span& span : spans)
        for (int first = 0; first < Lanes::perBlock; first += lanes)
            if (first < span.end && first + lanes > span.first) insertFrom(first, levels, span, facet);
}

void keepFound(const BlockLevels& levels, std::size_t lines) {
    for (std::size_t i = 0; i < lines; ++i)
        for (int first = 0; first < Lanes::perBlock; first += lanes) {
            float* const heights = levels.heightM[i].values + first;
            std::uint32_t* const buildings = levels.building[i].values + first;
            const V height = hn::Load(d, heights);
            const auto found = hn::Lt(height, hn::Set(d, farthest));
            hn::Store(hn::IfThenElseZero(found, height), d, heights);
            hn::Store(hn::IfThenElse(hn::RebindMask(du, found), hn::Load(du, buildings),
                                     hn::Set(du, LaneSources::nobody)),
                      du, buildings);
        }
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NearestLevels::NearestLevels(LaneSources& sources, int into)
    : sources_(sources),
      firstLine_(sources.line(into, 0)),
      lines_(std::size_t(sources.majors) * std::size_t(sources.levels)) {
    CacheLine<float> unknown;
    std::ranges::fill(unknown.values, std::numeric_limits<float>::infinity());
    std::fill_n(sources_.heightM.begin() + std::ptrdiff_t(firstLine_), lines_, unknown);
    std::fill_n(sources_.building.begin() + std::ptrdiff_t(firstLine_), lines_, CacheLine<std::uint32_t>{});
}

BlockLevels NearestLevels::levels() const {
    return {&sources_.heightM[firstLine_], &sources_.building[firstLine_], sources_.levels};
}

NOONMARK_KERNEL(insertSpans);
void NearestLevels::add(std::span<const Span> spans, const Facet& facet) {
    NOONMARK_CALL(insertSpans)(levels(), spans, facet);
}

NOONMARK_KERNEL(keepFound);
void NearestLevels::finish() { NOONMARK_CALL(keepFound)(levels(), lines_); }

}  // namespace noonmark
#endif
