#pragma once

#include "core/base/result.h"

namespace noonmark {

/// Advice for files that do not state their position on earth, or state an impossible one. All readers use
/// the same wording, so that the window can recognise it and offer the setting.
inline constexpr const char* crsAdvice = "State its coordinate reference system: --crs EPSG:number";
inline constexpr const char* anchorAdvice =
    "State the longitude and latitude of the mesh's origin (--mesh-anchor LON,LAT), or open it together with "
    "a file that has a position";

/// Whether stating ReadSettings::crs or ReadSettings::meshAnchor could resolve the error: its advice is, or
/// begins with, one of the two above.
[[nodiscard]] bool asksForPlace(const Error& error);

}  // namespace noonmark
