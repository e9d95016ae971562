#include "app/report/maps/height_source_colours.h"

#include <algorithm>

#include "core/describe/text.h"

namespace noonmark {

std::span<const HeightSourceColour, heightSources.size()> heightSourceColours() {
    static const std::array<HeightSourceColour, heightSources.size()> colours{{
        {HeightSource::measured, {0x00, 0x72, 0xb2}, NM_TEXT("measured")},
        {HeightSource::levels, {0xf0, 0xe4, 0x42}, NM_TEXT("from storeys")},
        {HeightSource::assumed, {0xd5, 0x5e, 0x00}, NM_TEXT("assumed")},
        {HeightSource::mesh, {0x56, 0xb4, 0xe9}, NM_TEXT("of a 3D model")},
        {HeightSource::designed, {0x4f, 0xc2, 0xa4}, NM_TEXT("designed")},
        {HeightSource::madeUp, {0x99, 0x99, 0x99}, NM_TEXT("made up")},
    }};
    return colours;
}

const HeightSourceColour& colourOf(HeightSource source) { return heightSourceColours()[std::size_t(source)]; }

HeightSource sourceOfHeight(const Building& building) {
    if (building.parts.empty()) return HeightSource::assumed;
    return std::ranges::max_element(building.parts, {}, &Part::topM)->heightSource;
}

SourceCounts countSources(const City& city) {
    SourceCounts counts{};
    for (const auto& building : city.buildings) ++counts[std::size_t(sourceOfHeight(*building))];
    return counts;
}

std::vector<LegendPatch> sourcePatches(const SourceCounts& counts) {
    std::vector<LegendPatch> patches;
    for (const HeightSourceColour& one : heightSourceColours())
        if (counts[std::size_t(one.source)] > 0)
            patches.push_back({one.colour, QString::fromUtf8(one.label.data(), qsizetype(one.label.size()))});
    return patches;
}

}  // namespace noonmark
