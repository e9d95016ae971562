#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/footprints/footprint.h"
#include "core/receivers/place.h"

namespace noonmark {

/// The middle of a street, local metres, and its width.
struct StreetLine {
    std::vector<glm::dvec2> points;
    double widthM = 0;
};

/// The ground that the lines of one street cover, as disjoint polygons: each line widened to both sides, ends
/// cut off square, bends rounded; ends that meet are joined round. Lines without a length are left out. Empty
/// where GEOS fails. O(points log points). Backend: street_blocks_geos.cpp.
std::vector<Footprint> widenStreet(const std::vector<StreetLine>& lines);

/// Polygons that may overlap as disjoint ones; the polygons themselves where GEOS fails.
std::vector<Footprint> uniteOverlapping(std::vector<Footprint> polygons);

/// One line of a street as read.
struct StreetPiece {
    std::string name;  ///< may be empty
    std::string id;    ///< "way 123"
    StreetLine line;
};

/// A street, or what of it lies between two cross streets.
struct StreetBlock {
    std::string name;  ///< "West 46th Street, 5th Avenue to 6th Avenue"; empty: the street has no name
    std::string id;    ///< of its first line
    std::size_t lineCount = 0;
    std::vector<StreetLine> lines;
};

/// The lines of each name together, and each line without a name for itself.
std::vector<StreetBlock> joinByName(const std::vector<StreetPiece>& pieces);

/// The same, cut where lines of another name share a point with them, as maps draw junctions; bridges share
/// none. A block is called after the cross streets at its ends in the order of their numbers; where several
/// meet, after the first. The halves of a dual carriageway make two blocks of the same name, which
/// joinAreas() makes one place of. What lies between two carriageways of the same cross street belongs to the
/// block beside it. Where a street ends without a cross street, at a dead end or at the edge of the data, its
/// block is called "West 46th Street, west of 12th Avenue". Streets without a name are not cut, and cut none.
/// O(n log n).
std::vector<StreetBlock> cutAtJunctions(const std::vector<StreetPiece>& pieces);

/// Joins areas of the same name and kind that lie within `nearM` of each other into one place, as a map draws
/// the lawns of one avenue one by one. The place's source names the first and how many more there are. In the
/// order of the first piece; names may still be empty or repeated (makeNamesUnique). O(n log n) but for the
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
