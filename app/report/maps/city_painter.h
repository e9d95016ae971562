#pragma once

#include "app/report/maps/map_view.h"
#include "app/report/sheets/style.h"
#include "core/city/city.h"

namespace noonmark {

/// How footprints are drawn.
struct FootprintStyle {
    QColor fill;
    QColor line;
    double linePt = 0.25;
};

/// The footprints of all buildings that `view` sees, as vectors. Parts that stand on the ground are filled;
/// parts that hang free (the ground below them is shown) are outlined with dashes. Clipping is up to the
/// caller. O(points).
void paintBuildings(const Canvas& canvas, const MapView& view, const City& city, const FootprintStyle& style);

}  // namespace noonmark
