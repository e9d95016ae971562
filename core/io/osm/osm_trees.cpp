#include "core/io/osm/osm_trees.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/geo/distance.h"
#include "core/io/heights/tree_fields.h"

namespace noonmark {

namespace {

constexpr double rowSpacingM = 8;
constexpr std::size_t maxInRow = 10'000;
constexpr double unitsPerDegree = 1e7;

LonLat placeOf(OsmPoint point) { return {point.lon / unitsPerDegree, point.lat / unitsPerDegree}; }

std::string_view findTag(const OsmTags& tags, std::string_view key) {
    const auto found = std::ranges::find(tags, key, &std::pair<std::string, std::string>::first);
    return found == tags.end() ? std::string_view() : std::string_view(found->second);
}

TreeFacts factsOf(const OsmTags& tags, const std::string& where, Warnings& warnings) {
    static const std::vector<KnownTreeField> fields = findTreeFields(osmTreeKeys());
    std::vector<std::string> values;
    for (const std::string& key : osmTreeKeys()) values.emplace_back(findTag(tags, key));
    return collectTreeFacts(fields, values, where, warnings);
}

// Along the line from its first point on; the rest of a piece carries over to the next.
std::vector<LonLat> placeRow(const OsmWay& way) {
    std::vector<LonLat> places{placeOf(way.points.front())};
    double toNextM = rowSpacingM;
    for (std::size_t i = 1; i < way.points.size() && places.size() < maxInRow; ++i) {
        const LonLat from = placeOf(way.points[i - 1]), to = placeOf(way.points[i]);
        const double lengthM = computeGreatCircleM(from, to);
        double atM = toNextM;
        for (; atM <= lengthM && places.size() < maxInRow; atM += rowSpacingM) {
            const double share = atM / lengthM;
            places.push_back({from.lonDeg + share * (to.lonDeg - from.lonDeg),
                              from.latDeg + share * (to.latDeg - from.latDeg)});
        }
        toNextM = atM - lengthM;
    }
    return places;
}

}  // namespace

const std::vector<std::string>& osmTreeKeys() {
    static const std::vector<std::string> keys{"natural",       "height",   "est_height", "diameter_crown",
                                               "circumference", "genus",    "species",    "taxon",
                                               "leaf_cycle",    "leaf_type"};
    return keys;
}

std::vector<ReadTree> listOsmTrees(const OsmMap& map, Warnings& warnings) {
    std::vector<ReadTree> trees;
    for (const OsmNode& node : map.points)
        if (findTag(node.tags, osmTreeKey) == "tree")
            trees.push_back(
                {placeOf(node.point), factsOf(node.tags, fmt::format("node {}", node.id), warnings)});
    for (const OsmWay& way : map.ways) {
        if (!way.line || way.points.empty() || findTag(way.tags, osmTreeKey) != "tree_row") continue;
        const std::string where = fmt::format("way {}", way.id);
        const TreeFacts facts = factsOf(way.tags, where, warnings);
        for (const LonLat place : placeRow(way)) trees.push_back({place, facts});
        warnings.push_back(
            {WarningKind::assumed, fmt::format("the trees of a row stand {:g} m apart", rowSpacingM), where});
    }
    return trees;
}

}  // namespace noonmark
