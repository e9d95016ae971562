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

}  // namespace noonmark
