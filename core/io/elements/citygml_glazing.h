#pragma once

#include "core/io/elements/read_glazing.h"

namespace noonmark {

/// Reads the surfaces of windows and doors of CityGML (level of detail 3): of each building or part those of
/// the highest level of detail that has some. Their ids are those of the windows, else "OBJECT window 1",
/// "OBJECT door 1". Heights are elevations, whatever `settings` says of them. Error: as readCityGml(), or no
/// such surfaces, too many, all too far away.
Result<GlazingRead> readCityGmlGlazing(const std::filesystem::path& file, const GlazingFileSettings& settings,
                                       const City& city, Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
