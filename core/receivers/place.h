#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// What a place is, for rules that treat places differently. What a kind stands for by default is below
/// (PlaceDefaults).
enum class PlaceKind : std::uint8_t {
    park,
    playground,
    schoolyard,
    plaza,
    greenstreet,
    cemetery,
    street,
    facade,
    stainedGlass,
    other,
};
/// All kinds, in the order of their values: placeKinds[i] == PlaceKind(i).
inline constexpr std::array placeKinds{PlaceKind::park,   PlaceKind::playground,  PlaceKind::schoolyard,
                                       PlaceKind::plaza,  PlaceKind::greenstreet, PlaceKind::cemetery,
                                       PlaceKind::street, PlaceKind::facade,      PlaceKind::stainedGlass,
                                       PlaceKind::other};

/// "park", "playground", ..., "stained glass", "other": the names in files and on the command line.
std::string_view nameOf(PlaceKind kind);
/// The kind of that name; nothing for any other text.
std::optional<PlaceKind> parsePlaceKind(std::string_view name);

/// A named area whose sunlight matters ("sunlight-sensitive resource"). Polygons may touch, but not overlap.
struct Place {
    std::string name;  ///< unique among the places of a project; never empty
    PlaceKind kind = PlaceKind::other;
    std::vector<Footprint> polygons;  ///< local metres; at least one
    std::string source;               ///< "OSM way 123", "parks.gpkg, feature 7"
    bool operator==(const Place&) const = default;
};

/// What is assumed about places of a kind where nothing else is stated. A rule or a project may say
/// otherwise.
struct PlaceDefaults {
    bool grows = false;  ///< has plants that need sun in the growing season
    /// Growing season of the northern mid-latitudes, both days included: April to October, as New York's
    /// environmental review takes it. growingSeason() turns it round in the south.
    std::chrono::month_day growsFrom{std::chrono::April, std::chrono::day{1}};
    std::chrono::month_day growsTo{std::chrono::October, std::chrono::day{31}};
    /// Hours of use on the wall clock, minutes after midnight. With the sun down they do not count.
    std::chrono::minutes usedFrom{0};
    std::chrono::minutes usedTo{24 * 60};
    bool operator==(const PlaceDefaults&) const = default;
};

PlaceDefaults defaultsOf(PlaceKind kind);

/// First and last day of a season, both included; it may run across the new year.
struct Season {
    std::chrono::month_day first, last;
    [[nodiscard]] bool holds(std::chrono::month_day day) const;
    bool operator==(const Season&) const = default;
};

/// The growing season of a kind at a latitude: south of the equator half a year later. All year within the
/// tropics.
Season growingSeason(PlaceKind kind, double latDeg);

}  // namespace noonmark
