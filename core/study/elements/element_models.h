#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

#include "core/study/elements/element_map.h"

namespace noonmark {

/// A copy of a CityJSON file (1.0 to 2.0, or a sequence) with the hours of sun that were measured on its
/// surfaces.
struct CityJsonWithHours {
    std::string text;
    std::size_t surfaces = 0;  ///< that carry hours
    std::size_t points = 0;    ///< that lie on one of them
};

/// Adds `sunlight_hours_per_day_mean`, `_min`, `_max` and `sunlight_points` to the semantic object of each
/// WallSurface, Window, Door, RoofSurface, OuterCeilingSurface and ClosureSurface, in every geometry, on
/// which points of the map lie: within 0.3 m of its plane, inside its ring, facing the same way. Surfaces
/// that share a semantic object get copies of it, so that each states its own hours. All else is as in the
/// file. `city`: the one that was measured; `crs`: of files that state none. Held in memory, as
/// loadCityJson() does. Error: the file cannot be read or is no CityJSON, has no coordinate reference system,
/// or none of its surfaces has a point (it is another city, or its surfaces have no semantics); cancelled().
/// Some 1 us a vertex.
Result<CityJsonWithHours> addHoursToCityJson(const std::filesystem::path& file, const std::string& crs,
                                             const City& city, const ElementMap& map,
                                             const std::stop_token& stop);

/// The same for the city of a study, if it was read from one CityJSON file (.json, .jsonl) that is still the
/// same and has marked surfaces with points. None otherwise, or if the work was stopped.
std::optional<std::string> copyCityJsonOf(const ElementStudy& study, const ElementMap& map,
                                          const std::stop_token& stop = {});

/// The points as a binary glTF 2.0 file: the rectangle of each, 3 cm in front of its wall, in the colours of
/// gross shadow (measures/palette.h, up to the sunlit minutes of a day or the largest value), without light.
/// In metres from the project's origin: x east, y up, z south. Attributes of the corners: `_SUNLIT_MIN`,
/// `_GROSS_MIN`, `_CONTINUOUS_MIN`, as in elements.csv; `extras` of the mesh lists the ids in the order of
/// the rectangles, four corners each. Some 150 bytes a point.
std::string toGlb(const ElementMap& map);

}  // namespace noonmark
