#pragma once

#include <optional>
#include <string>

#include "core/geo/frame.h"
#include "core/receivers/region.h"

namespace noonmark {

/// "W,S,E,N" in degrees when the region is the box of these four numbers (to 1 cm), else nothing. Across the
/// antimeridian W is the larger number.
std::optional<std::string> boxTextOf(const Region& region, const Frame& frame);

/// The region as GeoJSON (RFC 7946): a feature whose geometry is a MultiPolygon in degrees. Across the
/// antimeridian its longitudes run on past 180, so that it stays in one piece.
std::string regionGeoJson(const Region& region, const Frame& frame);

}  // namespace noonmark
