#pragma once

#include <optional>
#include <string>

#include "core/city/city.h"
#include "core/geo/frame.h"
#include "core/receivers/region.h"

namespace noonmark {

/// The name of the region's polygon file, which goes with an answer whose region nothing shorter states.
inline constexpr const char* regionFileName = "region.geojson";

/// "W,S,E,N" in degrees when regionFromLonLatBox makes exactly this region of these four numbers, with no
/// more digits than that takes; else nothing. Across the antimeridian W is the larger number.
std::optional<std::string> boxTextOf(const Region& region, const Frame& frame);

/// The region as `--region` of a study takes it: a box, "city" for the box around all buildings, or
/// regionFileName.
std::string regionText(const Region& region, const City& city);

/// The region as GeoJSON (RFC 7946): a feature whose geometry is a MultiPolygon in degrees, in all digits.
/// Straight sides that are long get points between, as many as readRegion would bend them at: it reads the
/// same outline, to float32's last bit. Across the antimeridian its longitudes run on past 180, so that it
/// stays in one piece.
std::string regionGeoJson(const Region& region, const Frame& frame);

}  // namespace noonmark
