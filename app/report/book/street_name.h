#pragma once

#include <optional>

#include "app/report/maps/map_view.h"
#include "core/receivers/place.h"

namespace noonmark {

/// Where the name of a street can be painted along it.
struct StreetNameSpot {
    QPointF middle;       ///< of the text, painter units
    double angleDeg = 0;  ///< clockwise in the picture, from -90 to 90, so that the text is not upside down
    double room = 0;      ///< along the street, painter units
};

/// The middle of the longest straight side of a street that is seen in the view, moved to the middle of the
/// street, whose width is taken as that of the whole. Nothing where no side is seen.
std::optional<StreetNameSpot> findStreetNameSpot(const Place& street, const MapView& view);

}  // namespace noonmark
