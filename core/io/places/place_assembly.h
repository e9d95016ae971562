#pragma once

#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/io/places/street_blocks.h"
#include "core/receivers/place.h"

namespace noonmark {

/// Joins areas of the same name and kind that lie within `nearM` of each other into one place, as a map draws
/// the lawns of one avenue one by one. The place's source names the first and how many more there are. In the
/// order of the first piece; names may still be empty or repeated (nameApart). O(n log n) but for the
/// overlay.
std::vector<Place> joinAreas(std::vector<Place> areas, double nearM = 50);

/// How streets become places.
struct StreetPlaces {
    bool whole = false;    ///< each street as one place; else cut at its junctions
    double sidewalkM = 0;  ///< above 0: strips of this width beside the carriageway are places of their own
};

/// The carriageways of streets, whole or cut (cutAtJunctions); with sidewalks, of which no carriageway takes
/// anything, in two places each: "..., carriageway" and "..., sidewalks". Pieces of one name within 50 m of
/// each other are one place. Lines that are too tangled, or without a length, give a warning.
std::vector<Place> makeStreets(const std::vector<StreetPiece>& pieces, const StreetPlaces& how,
                               const std::string& sourceStart, Warnings& warnings);

}  // namespace noonmark
