#pragma once

#include <QString>

#include "app/window/view/polygon_tool.h"
#include "core/receivers/place.h"
#include "core/receivers/region.h"

namespace noonmark {

/// "park", "school grounds", ...: the kind of a place in the window.
QString describeKind(PlaceKind kind);

/// Describes a region: name, size in metres, area, and the approximate number of cells in its bounding box.
QString describeRegion(const Region& region, double cellM);

/// Measures of a polygon being drawn: "24.6 m, 812 m²"; empty before there is a side.
QString describeDrawn(const PolygonTool& tool);

}  // namespace noonmark
