#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// What a place is, for rules that treat places differently. What a kind stands for by default is in
/// place_kinds.h.
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

}  // namespace noonmark
