#include "core/io/places/place_tags.h"

#include <algorithm>
#include <string_view>

#include "core/io/heights/height_text.h"

namespace noonmark {

namespace {

std::string_view valueOf(const PlaceTags& tags, std::string_view key) {
    const auto found = tags.find(key);
    return found == tags.end() ? std::string_view{} : std::string_view(found->second);
}

struct AreaRule {
    std::string_view key, value;
    PlaceKind kind;
};

// The first that fits decides: what a place is used for before what covers it.
constexpr std::array areaRules{
    AreaRule{"leisure", "playground", PlaceKind::playground},
    AreaRule{"leisure", "pitch", PlaceKind::playground},
    AreaRule{"amenity", "school", PlaceKind::schoolyard},
    AreaRule{"amenity", "kindergarten", PlaceKind::schoolyard},
    AreaRule{"amenity", "college", PlaceKind::schoolyard},
    AreaRule{"amenity", "university", PlaceKind::schoolyard},
    AreaRule{"landuse", "cemetery", PlaceKind::cemetery},
    AreaRule{"amenity", "grave_yard", PlaceKind::cemetery},
    AreaRule{"leisure", "park", PlaceKind::park},
    AreaRule{"leisure", "nature_reserve", PlaceKind::park},
    AreaRule{"leisure", "dog_park", PlaceKind::park},
    AreaRule{"leisure", "common", PlaceKind::park},
    AreaRule{"landuse", "recreation_ground", PlaceKind::park},
    AreaRule{"landuse", "village_green", PlaceKind::park},
    AreaRule{"place", "square", PlaceKind::plaza},
    AreaRule{"highway", "pedestrian", PlaceKind::plaza},
    AreaRule{"amenity", "marketplace", PlaceKind::plaza},
    AreaRule{"natural", "beach", PlaceKind::park},
    AreaRule{"natural", "wood", PlaceKind::park},
    AreaRule{"natural", "grassland", PlaceKind::park},
    AreaRule{"natural", "heath", PlaceKind::park},
    AreaRule{"natural", "scrub", PlaceKind::greenstreet},
    AreaRule{"landuse", "grass", PlaceKind::greenstreet},
    AreaRule{"landuse", "flowerbed", PlaceKind::greenstreet},
    AreaRule{"historic", "monument", PlaceKind::other},
    AreaRule{"historic", "memorial", PlaceKind::other},
    AreaRule{"historic", "archaeological_site", PlaceKind::other},
    AreaRule{"historic", "ruins", PlaceKind::other},
    AreaRule{"historic", "castle", PlaceKind::other},
};

struct StreetRule {
    std::string_view highway;
    double widthM;  // of the carriageway, where nothing is tagged
};

constexpr std::array streetRules{
    StreetRule{"trunk", 14},        StreetRule{"primary", 14},     StreetRule{"secondary", 12},
    StreetRule{"tertiary", 10},     StreetRule{"unclassified", 7}, StreetRule{"residential", 8},
    StreetRule{"living_street", 6}, StreetRule{"pedestrian", 6},   StreetRule{"road", 7},
};

constexpr double minWidthM = 1, maxWidthM = 100, maxLanes = 20;

std::optional<double> taggedWidth(const PlaceTags& tags) {
    const auto width = parseMetres(valueOf(tags, "width"));
    if (width && *width >= minWidthM && *width <= maxWidthM) return width;
    const auto lanes = parseLevels(valueOf(tags, "lanes"));
    if (lanes && *lanes >= 1 && *lanes <= maxLanes) return *lanes * metresPerLane;
    return std::nullopt;
}

}  // namespace

bool isUnderground(const PlaceTags& tags) {
    const std::string_view tunnel = valueOf(tags, "tunnel"), layer = valueOf(tags, "layer");
    return (!tunnel.empty() && tunnel != "no") || layer.starts_with('-') ||
           valueOf(tags, "location") == "underground";
}

std::optional<PlaceKind> classifyArea(const PlaceTags& tags) {
    const std::string_view building = valueOf(tags, "building");
    if ((!building.empty() && building != "no") || isUnderground(tags)) return std::nullopt;
    // A named garden is used like a park; the many without a name are plantings beside streets and houses.
    if (valueOf(tags, "leisure") == "garden")
        return valueOf(tags, "name").empty() ? PlaceKind::greenstreet : PlaceKind::park;
    for (const AreaRule& rule : areaRules)
        if (valueOf(tags, rule.key) == rule.value) return rule.kind;
    return std::nullopt;
}

std::optional<StreetWidth> readStreetWidth(const PlaceTags& tags) {
    const auto rule = std::ranges::find(streetRules, valueOf(tags, "highway"), &StreetRule::highway);
    if (rule == streetRules.end() || isUnderground(tags)) return std::nullopt;
    if (const auto width = taggedWidth(tags)) return StreetWidth{*width, false};
    return StreetWidth{rule->widthM, true};
}

StreetWidth readLineWidth(const PlaceTags& tags) {
    if (const auto width = taggedWidth(tags)) return {*width, false};
    return {std::ranges::find(streetRules, "residential", &StreetRule::highway)->widthM, true};
}

}  // namespace noonmark
