#pragma once

#include "app/report/maps/legend_painter.h"
#include "core/study/elements/element_map.h"

namespace noonmark {

/// The legend of points: up to the sunlit minutes of a day, or the largest value if that is larger.
Legend makeLegend(const ElementMap& map, ShadowMeasure measure, const LegendChoice& choice = {});

/// The legend of sheets, which state hours of sun, or its share where that is chosen.
Legend makeSunLegend(const ElementMap& map, const LegendChoice& choice);

}  // namespace noonmark
