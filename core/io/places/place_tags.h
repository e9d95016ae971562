#pragma once

// The folder core/io/places reads places: place_tags.h (this file) holds the rules of OpenStreetMap's tags,
// place_assembly.h turns street lines into polygons and joins features of one name, and
// read_places.h reads files.

#include <array>
#include <map>
#include <optional>
#include <string>

#include "core/receivers/place.h"

namespace noonmark {

/// PlaceTags of one feature: key and value, trimmed.
using PlaceTags = std::map<std::string, std::string, std::less<>>;

/// The keys that decide whether an area is a place and of which kind.
inline constexpr std::array placeKeys{"leisure", "landuse", "amenity", "historic",
                                      "natural", "place",   "highway", "tourism"};

/// Whether the tags say that it lies under the ground: a tunnel, a negative layer, an underground location.
bool isUnderground(const PlaceTags& tags);

/// The kind of an area by its OpenStreetMap tags (https://wiki.openstreetmap.org/wiki/Map_features); nothing
/// for an area that is not a place: a building, water, a car park, residential land, anything underground.
std::optional<PlaceKind> classifyArea(const PlaceTags& tags);

/// The width of a street.
struct StreetWidth {
    double widthM = 0;
    bool assumed = false;  ///< by its class, since neither width nor lanes are tagged
};

/// Metres a lane, where only the number of lanes is tagged.
inline constexpr double metresPerLane = 3.2;

/// The width of a street on the ground by the tags of its line: width (1 to 100 m, with its unit), else lanes
/// x metresPerLane, else a usual width of its class. Nothing for lines that are no streets: motorways, paths,
/// footways, steps, service roads, tunnels, and what is proposed or under construction.
std::optional<StreetWidth> readStreetWidth(const PlaceTags& tags);
/// The same for a line of a layer of streets that has no class: else as wide as residential streets.
StreetWidth readLineWidth(const PlaceTags& tags);

}  // namespace noonmark
