#pragma once

// The folder core/study/text turns results into text: JSON for study.json and info (error_text.h,
// height_facts_text.h, terrain_text.h), CSV (breakdown_text.h), sentences for people (in the same files), and
// a region as a command line or GeoJSON (this file).

#include <optional>
#include <string>

#include "core/city/city.h"
#include "core/geo/frame.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// The name of the region's polygon file, which accompanies a result if no shorter text states its region.
inline constexpr const char* regionFileName = "region.geojson";

/// "W,S,E,N" in degrees if makeRegionFromLonLatBox makes exactly this region of these four numbers, with as
/// few digits as possible; else nothing. Across the antimeridian W is the larger number.
std::optional<std::string> formatBox(const Region& region, const Frame& frame);

/// The region in the form of a study's `--region`: a box, "city" for the box around all buildings, or
/// regionFileName.
std::string formatRegion(const Region& region, const City& city);

/// The region as GeoJSON (RFC 7946): a feature whose geometry is a MultiPolygon in degrees, in full
/// precision. Long straight sides get as many points as readRegion would add, so that it reads the same
/// outline, to float32's last bit. Across the antimeridian longitudes continue beyond 180, so that the region
/// stays in one piece.
std::string regionGeoJson(const Region& region, const Frame& frame);

/// The name that people gave it; empty: none.
std::string nameOf(const Region& region);

}  // namespace noonmark
