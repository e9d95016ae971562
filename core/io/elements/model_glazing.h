#pragma once

#include "core/io/elements/read_glazing.h"

namespace noonmark {

/// Reads the surfaces of CityJSON or CityJSONSeq that are marked as Window or Door (level of detail 3): of
/// each object those of its geometry of the highest level of detail that has some. Their ids are those of the
/// surfaces' attributes ("id" or "name"), else "OBJECT window 1", "OBJECT door 1". Heights are elevations,
/// whatever `settings` says of them. A surface that cannot be used is left out with a warning. The whole file
/// is held in memory. Error: the file cannot be read or is no CityJSON, states no coordinate reference
/// system, has too many or no such surfaces; cancelled().
Result<GlazingRead> readCityJsonGlazing(const std::filesystem::path& file,
                                        const GlazingFileSettings& settings, const City& city,
                                        const std::stop_token& stop);

/// Reads the surfaces of windows and doors of CityGML (level of detail 3): of each building or part those of
/// the highest level of detail that has some. Their ids are those of the windows, else "OBJECT window 1",
/// "OBJECT door 1". Heights are elevations, whatever `settings` says of them. Error: as readCityGml(), or no
/// such surfaces, too many, all too far away.
Result<GlazingRead> readCityGmlGlazing(const std::filesystem::path& file, const GlazingFileSettings& settings,
                                       const City& city, Progress& progress, const std::stop_token& stop);

/// Reads the windows and doors of an IFC (2x3 or 4) where the file states that it stands: each the rectangle
/// around its body in the outer face of its wall, with its name and the number of its storey. It stands as
/// high as the building of the city at its place that is as tall as the file's, else on the ground. Those
/// that open to no side, as inner doors, are left out with a warning. Error: the file cannot be read, states
/// no place, has no windows or too many, all are too far away. Some 20 ms for each window in a building of
/// 100,000 triangles.
Result<GlazingRead> readIfcGlazing(const std::filesystem::path& file, const GlazingFileSettings& settings,
                                   const City& city, const std::stop_token& stop);

}  // namespace noonmark
