#pragma once

#include <QString>

#include "app/window/view/polygon_tool.h"
#include "core/receivers/region.h"

namespace noonmark {

/// "12,345 m²", "67.8 ha" from ten hectares on.
QString describeArea(double areaM2);

/// A region in words: name, size in metres, area, and about how many cells its box has.
QString describeRegion(const Region& region, double cellM);

/// What a polygon that is being drawn measures: "24.6 m, 812 m²"; empty before there is a side.
QString describeDrawn(const PolygonTool& tool);

}  // namespace noonmark
