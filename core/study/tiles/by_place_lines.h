#pragma once

#include <string>
#include <vector>

#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

/// What a tile knows of one city besides its places.
struct SunOfTile {
    std::string engine;
    std::optional<SampledError> error;
    std::vector<std::optional<SampledError>> dateErrors;
    std::vector<ShownError> errors;
    Warnings warnings;
};

/// The first line of a tile's file.
struct TileLine {
    std::vector<SunOfTile> cities;  ///< the baseline first
    double seconds = 0;
};

/// Each of the others.
struct PlaceLine {
    std::string name;
    std::vector<SunOfPlace> sun;     ///< in each city, without its cells
    std::vector<SunChange> changes;  ///< of each city but the baseline
};

/// A line of JSON for the tile, and one for each place. Numbers are read back to the last bit.
std::string formatLines(const SunOfCities& sun);

/// Throws exceptions of nlohmann for a line of another structure.
TileLine parseTileLine(const std::string& line);
PlaceLine parsePlaceLine(const std::string& line);

}  // namespace noonmark
