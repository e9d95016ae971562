#pragma once

#include "app/report/maps/map_view.h"
#include "app/report/maps/style.h"
#include "core/city/city.h"

namespace noonmark {

/// Colours and line width of footprints.
struct FootprintStyle {
    QColor fill;
    QColor line;
    double linePt = 0.25;
};

/// Paints the footprints of all buildings in `view` as vectors. Parts that stand on the ground are filled;
/// overhangs have a dashed outline, because the ground below them is shown. The caller clips. O(points).
void paintBuildings(const Canvas& canvas, const MapView& view, const City& city, const FootprintStyle& style);

/// Whether paintBuildings() draws a dashed outline: of parts that leave the ground below them open.
bool showsOverhangs(const MapView& view, const City& city);

}  // namespace noonmark
