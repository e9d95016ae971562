#include "core/io/context/context_tags.h"

#include <algorithm>

namespace noonmark {

namespace {

struct TagRule {
    std::string_view key, value;
    ContextKind kind;
};

// The first that fits decides.
constexpr std::array areaRules{
    TagRule{"natural", "water", ContextKind::water},
    TagRule{"waterway", "riverbank", ContextKind::water},
    TagRule{"waterway", "dock", ContextKind::water},
    TagRule{"landuse", "reservoir", ContextKind::water},
    TagRule{"landuse", "basin", ContextKind::water},
    TagRule{"leisure", "swimming_pool", ContextKind::water},
    TagRule{"leisure", "pitch", ContextKind::sports},
    TagRule{"leisure", "track", ContextKind::sports},
    TagRule{"leisure", "playground", ContextKind::sports},
    TagRule{"landuse", "cemetery", ContextKind::cemetery},
    TagRule{"amenity", "grave_yard", ContextKind::cemetery},
    TagRule{"leisure", "park", ContextKind::park},
    TagRule{"leisure", "garden", ContextKind::park},
    TagRule{"leisure", "dog_park", ContextKind::park},
    TagRule{"leisure", "common", ContextKind::park},
    TagRule{"leisure", "nature_reserve", ContextKind::park},
    TagRule{"leisure", "golf_course", ContextKind::park},
    TagRule{"landuse", "recreation_ground", ContextKind::park},
    TagRule{"landuse", "village_green", ContextKind::park},
    TagRule{"landuse", "forest", ContextKind::wood},
    TagRule{"natural", "wood", ContextKind::wood},
    TagRule{"natural", "scrub", ContextKind::wood},
    TagRule{"landuse", "grass", ContextKind::grass},
    TagRule{"landuse", "meadow", ContextKind::grass},
    TagRule{"landuse", "flowerbed", ContextKind::grass},
    TagRule{"natural", "grassland", ContextKind::grass},
    TagRule{"natural", "heath", ContextKind::grass},
    TagRule{"place", "square", ContextKind::plaza},
    TagRule{"highway", "pedestrian", ContextKind::plaza},
    TagRule{"amenity", "marketplace", ContextKind::plaza},
};

struct LineRule {
    std::string_view key, value;
    ContextKind kind;
    double widthM;  // where nothing is tagged
};

constexpr std::array lineRules{
    LineRule{"highway", "motorway", ContextKind::street, 16},
    LineRule{"highway", "motorway_link", ContextKind::street, 7},
    LineRule{"highway", "trunk_link", ContextKind::street, 7},
    LineRule{"highway", "primary_link", ContextKind::street, 7},
    LineRule{"highway", "secondary_link", ContextKind::street, 7},
    LineRule{"highway", "tertiary_link", ContextKind::street, 7},
    LineRule{"highway", "busway", ContextKind::street, 7},
    LineRule{"highway", "service", ContextKind::street, 4},
    LineRule{"highway", "track", ContextKind::path, 3},
    LineRule{"highway", "footway", ContextKind::path, 2},
    LineRule{"highway", "path", ContextKind::path, 2},
    LineRule{"highway", "cycleway", ContextKind::path, 2.5},
    LineRule{"highway", "bridleway", ContextKind::path, 2},
    LineRule{"highway", "steps", ContextKind::path, 2},
    LineRule{"railway", "rail", ContextKind::rail, 1.5},
    LineRule{"railway", "light_rail", ContextKind::rail, 1.5},
    LineRule{"railway", "tram", ContextKind::rail, 1.5},
    LineRule{"railway", "subway", ContextKind::rail, 1.5},
    LineRule{"railway", "narrow_gauge", ContextKind::rail, 1},
    LineRule{"waterway", "river", ContextKind::waterway, 12},
    LineRule{"waterway", "canal", ContextKind::waterway, 8},
    LineRule{"waterway", "stream", ContextKind::waterway, 2},
    LineRule{"waterway", "ditch", ContextKind::waterway, 1},
    LineRule{"waterway", "drain", ContextKind::waterway, 1},
};

std::string_view valueOf(const PlaceTags& tags, std::string_view key) {
    const auto found = tags.find(key);
    return found == tags.end() ? std::string_view{} : std::string_view(found->second);
}

const LineRule* findLine(const PlaceTags& tags) {
    const auto fits = [&](const LineRule& rule) { return valueOf(tags, rule.key) == rule.value; };
    const auto rule = std::ranges::find_if(lineRules, fits);
    return rule == lineRules.end() ? nullptr : &*rule;
}

// A river or lake of a negative layer lies under bridges, not under the ground.
bool isOpenWater(const TagRule& rule) { return rule.kind == ContextKind::water && rule.key != "leisure"; }

PlaceTags withoutLayer(PlaceTags tags) {
    tags.erase("layer");
    return tags;
}

}  // namespace

std::optional<ContextKind> classifyContextArea(const PlaceTags& tags) {
    const std::string_view building = valueOf(tags, "building");
    if (!building.empty() && building != "no") return std::nullopt;
    const auto fits = [&](const TagRule& rule) { return valueOf(tags, rule.key) == rule.value; };
    const auto rule = std::ranges::find_if(areaRules, fits);
    if (rule == areaRules.end()) return std::nullopt;
    const bool hidden = isOpenWater(*rule) ? isUnderground(withoutLayer(tags)) : isUnderground(tags);
    return hidden ? std::nullopt : std::optional(rule->kind);
}

std::optional<ContextKind> classifyContextLine(const PlaceTags& tags) {
    if (isUnderground(tags)) return std::nullopt;
    if (readStreetWidth(tags)) return ContextKind::street;
    const LineRule* rule = findLine(tags);
    return rule == nullptr ? std::nullopt : std::optional(rule->kind);
}

std::optional<ContextKind> classifyContextPoint(const PlaceTags& tags) {
    if (valueOf(tags, "natural") == "tree") return ContextKind::tree;
    return std::nullopt;
}

bool isCoastline(const PlaceTags& tags) { return valueOf(tags, "natural") == "coastline"; }

double widthOfLine(ContextKind kind, const PlaceTags& tags) {
    if (const auto street = readStreetWidth(tags)) return street->widthM;
    if (const LineRule* rule = findLine(tags)) return rule->widthM;
    return kind == ContextKind::street ? 7 : 2;
}

}  // namespace noonmark
