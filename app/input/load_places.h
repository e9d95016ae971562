#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/io/places/read_places.h"

namespace noonmark {

/// The places of those files of a city that state them: OpenStreetMap's. None from samples and other formats.
/// Names are unique. Error: a file cannot be read; cancelled().
Result<PlacesRead> loadCityPlaces(const std::vector<std::string>& files, const PlaceSettings& settings,
                                  const Frame& frame, Progress& progress, const std::stop_token& stop);

/// The places of all these files, of any format that readPlaces() reads, joined to those of `before`. Names
/// are unique.
Result<PlacesRead> loadPlaceFiles(const std::vector<std::string>& files, const PlaceSettings& settings,
                                  const Frame& frame, PlacesRead before, Progress& progress,
                                  const std::stop_token& stop);

}  // namespace noonmark
