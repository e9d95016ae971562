#pragma once

#include "app/report/maps/change_scale.h"
#include "app/report/maps/legend_painter.h"
#include "scenarios/impact/impact.h"

namespace noonmark {

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

}  // namespace noonmark
