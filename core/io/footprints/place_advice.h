#pragma once

#include "core/base/result.h"

namespace noonmark {

/// What readers advise when a file does not say where on the earth it lies, or says what cannot be. One
/// wording for all of them, so that a program can offer the setting itself.
inline constexpr const char* crsAdvice = "State the coordinate reference system it is in: --crs EPSG:number";
inline constexpr const char* anchorAdvice =
    "State the longitude and latitude of the mesh's origin (--mesh-anchor LON,LAT), or open it together with "
    "a file "
    "that has a place";

/// Whether stating ReadSettings::crs or ReadSettings::meshAnchor may let the files be read: the advice is one
/// of the two above, or begins with it.
[[nodiscard]] bool asksForPlace(const Error& error);

}  // namespace noonmark
