#pragma once

#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/io/places/street_polygons.h"
#include "core/receivers/place.h"

namespace noonmark {

/// One line of a street as read.
struct StreetPiece {
    std::string name;  ///< may be empty
    std::string id;    ///< "way 123"
    StreetLine line;
};

/// Joins areas of the same name and kind that lie within `nearM` of each other into one place, as a map draws
/// the lawns of one avenue one by one. The place's source names the first and how many more there are. In the
/// order of the first piece; names may still be empty or repeated (nameApart). O(n log n) but for the
/// overlay.
std::vector<Place> joinAreas(std::vector<Place> areas, double nearM = 50);

/// A place for each street name, and one for each line without a name: its carriageway or, where `sidewalkM`
/// is above 0, strips of that width on both sides of it, as far as no street's carriageway lies there. Lines
/// that are too tangled, or without a length, give a warning.
std::vector<Place> makeStreets(const std::vector<StreetPiece>& pieces, double sidewalkM,
                               const std::string& sourceStart, Warnings& warnings);

}  // namespace noonmark
