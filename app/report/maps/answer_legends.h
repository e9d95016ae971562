#pragma once

#include <QColor>
#include <array>
#include <span>
#include <string_view>

#include "app/report/maps/change_scale.h"
#include "app/report/maps/legend_painter.h"
#include "core/city/city.h"
#include "core/review/criteria/verdict.h"
#include "core/study/elements/element_map.h"
#include "scenarios/impact/impact.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// The legend of points: up to the sunlit minutes of a day, or the largest value if that is larger.
Legend makeLegend(const ElementMap& map, ShadowMeasure measure, const LegendChoice& choice = {});

/// The legend of sheets, which state hours of sun, or its share where that is chosen.
Legend makeSunLegend(const ElementMap& map, const LegendChoice& choice);

/// Colours of cells that are not receivers in both cities; distinct from those of more and less shadow.
namespace ground {
constexpr QColor becameBuilding{0x70, 0x72, 0x78};
constexpr QColor becameGround{0xf3, 0xd6, 0x6b};
}  // namespace ground

/// Minutes of change in grid order, NaN unless a receiver in both cities. A member of `impact`.
const std::vector<float>& getValues(const Impact& impact, ShadowMeasure measure);

/// True for the difference of a single moment: more or less shadow, no minutes.
bool isInstant(const Impact& impact);

/// Where the choice shows sun, the signs are those of sun: minutes of it lost are below 0. A legend symmetric
/// about no change. The unit states whether the scale is locked, and the largest change if it exceeds the
/// scale. An unlocked scale contains 98 % of the cells that change, so that one dark corner does not make the
/// rest pale. O(cells).
Legend makeLegend(const Impact& impact, ShadowMeasure measure, const ChangeScale& scale,
                  const LegendChoice& choice = {});

/// The colour of a cell in those of the legend; empty where the change is at most a thousandth of a minute,
/// and where the cell is not a receiver in both cities unless it became building or ground.
std::optional<QColor> pickColour(const Impact& impact, ShadowMeasure measure, std::size_t cell,
                                 const ColourScale& scale);

/// A legend symmetric about 0: wanted shade has the colour of less shadow, unwanted shadow that of more. The
/// scale contains 98 % of the cells; `unit` states the largest value if it exceeds the scale.
Legend makeLegend(const Score& score, const LegendChoice& choice = {});

/// The colour of a verdict on maps, tiles and sheets, in the view and on paper: each two can be told apart
/// with normal and with colour-blind eyes. The window's text colours, which must contrast with its
/// background, are verdictColour().
QColor verdictMark(Verdict verdict);

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
