#pragma once

#include <QColor>
#include <array>
#include <span>
#include <string_view>

#include "app/report/maps/legend_painter.h"
#include "core/city/city.h"

namespace noonmark {

/// The colour of buildings by where their heights come from.
struct HeightSourceColour {
    HeightSource source;
    QColor colour;
    std::string_view label;  ///< NM_TEXT: "from storeys"
};

/// One for each source, in the order of heightSources. The colours are Okabe and Ito's, which all kinds of
/// colour vision tell apart, but for what is designed, which has that of proposals.
std::span<const HeightSourceColour, heightSources.size()> heightSourceColours();
const HeightSourceColour& colourOf(HeightSource source);

/// The source of a building's highest part, which is what is seen of its height.
HeightSource sourceOfHeight(const Building& building);

/// Buildings by sourceOfHeight(), counted as heightSources are.
using SourceCounts = std::array<std::size_t, heightSources.size()>;
SourceCounts countSources(const City& city);

/// Patches of the sources that occur. Labels are English.
std::vector<LegendPatch> sourcePatches(const SourceCounts& counts);

}  // namespace noonmark
