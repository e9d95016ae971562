#include "core/io/context/read_context.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>

#include "core/city/footprints/geos_shapes.h"
#include "core/city/footprints/plan_overlay.h"

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

namespace {

constexpr double minReachM = 100;
constexpr double reachShare = 0.1;  // of the box's shorter side
constexpr double maxDoubt = 0.01;   // share of an area's coast that may say otherwise: rounding

using Spot = std::pair<double, double>;
using Edge = std::pair<std::pair<float, float>, std::pair<float, float>>;

// As findFaces() rounds its corners.
glm::dvec2 rounded(glm::dvec2 point) { return glm::round(point / overlayGridM) * overlayGridM; }

Edge edgeOf(glm::vec2 from, glm::vec2 to) { return {{from.x, from.y}, {to.x, to.y}}; }

bool isInside(const Box2& box, glm::dvec2 point) {
    return point.x > double(box.low.x) && point.x < double(box.high.x) && point.y > double(box.low.y) &&
           point.y < double(box.high.y);
}

/// The part of a line inside the box (Liang and Barsky).
std::optional<PlanLine> clipLine(const PlanLine& line, const Box2& box) {
    double from = 0, to = 1;
    const glm::dvec2 along = line.b - line.a;
    for (int axis = 0; axis < 2; ++axis) {
        const double low = double(box.low[axis]) - line.a[axis], high = double(box.high[axis]) - line.a[axis];
        if (along[axis] == 0) {
            if (low > 0 || high < 0) return std::nullopt;
            continue;
        }
        const auto [first, last] = std::minmax({low / along[axis], high / along[axis]});
        from = std::max(from, first);
        to = std::min(to, last);
    }
    if (from >= to) return std::nullopt;
    return PlanLine{rounded(line.a + from * along), rounded(line.a + to * along)};
}

/// The nearest point on the sides of a box, for a point inside it.
glm::dvec2 nearestOnSides(const Box2& box, glm::dvec2 point) {
    const glm::dvec2 low(box.low), high(box.high);
    const std::array<glm::dvec2, 4> feet{
        {{low.x, point.y}, {high.x, point.y}, {point.x, low.y}, {point.x, high.y}}};
    return *std::ranges::min_element(feet, {}, [&](glm::dvec2 foot) { return glm::distance(foot, point); });
}

class SeaFinder {
public:
    SeaFinder(const std::vector<CoastLine>& coast, const Box2& box) : box_(box) {
        for (const CoastLine& line : coast)
            for (std::size_t i = 1; i < line.size(); ++i) add({line[i - 1], line[i]});
        continueEnds(coast);
    }

    Sea find() {
        if (directed_.empty()) return std::move(sea_);
        for (Footprint& face : findFaces(linesAndSides()))
            if (isSea(face)) sea_.polygons.push_back(std::move(face));
        return std::move(sea_);
    }

private:
    void add(const PlanLine& line) {
        const auto within = clipLine(line, box_);
        if (!within || within->a == within->b) return;
        lines_.push_back(*within);
        directed_.emplace(edgeOf(glm::vec2(within->a), glm::vec2(within->b)),
                          glm::distance(within->a, within->b));
    }

    // Ends that no other line goes on from: +1 where a line begins, -1 where it ends.
    void continueEnds(const std::vector<CoastLine>& coast) {
        std::map<Spot, int> ends;
        for (const CoastLine& line : coast) {
            if (line.size() < 2) continue;
            ++ends[{line.front().x, line.front().y}];
            --ends[{line.back().x, line.back().y}];
        }
        for (const auto& [spot, net] : ends)
            if (const glm::dvec2 end(spot.first, spot.second); net != 0 && isInside(box_, end))
                continueEnd(end, net);
    }

    void continueEnd(glm::dvec2 end, int net) {
        const glm::dvec2 size(box_.high - box_.low), foot = nearestOnSides(box_, end);
        const double distance = glm::distance(foot, end);
        if (std::abs(net) != 1 || distance > std::max(minReachM, reachShare * std::min(size.x, size.y)))
            return sea_.openEnds.push_back(end);
        sea_.continuedM.push_back(distance);
        net > 0 ? add({foot, end}) : add({end, foot});
    }

    [[nodiscard]] std::vector<PlanLine> linesAndSides() const {
        std::vector<PlanLine> lines = lines_;
        const glm::dvec2 low(box_.low), high(box_.high);
        const std::array<glm::dvec2, 4> corners{{low, {high.x, low.y}, high, {low.x, high.y}}};
        for (std::size_t i = 0; i < 4; ++i)
            lines.push_back({rounded(corners[i]), rounded(corners[(i + 1) % 4])});
        return lines;
    }

    // Metres of coast with the face on its left (land) and on its right (sea).
    void measure(const Ring& ring, double& landM, double& seaM) const {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::vec2 from = ring[i], to = ring[(i + 1) % ring.size()];
            if (const auto left = directed_.find(edgeOf(from, to)); left != directed_.end())
                landM += left->second;
            if (const auto right = directed_.find(edgeOf(to, from)); right != directed_.end())
                seaM += right->second;
        }
    }

    // A footprint lies on the left of its rings.
    bool isSea(const Footprint& face) {
        double landM = 0, seaM = 0;
        measure(face.outer, landM, seaM);
        for (const Ring& hole : face.holes) measure(hole, landM, seaM);
        if (seaM <= maxDoubt * landM || seaM == 0) return false;
        if (landM > maxDoubt * seaM) return ++sea_.contradictions, false;
        return std::ranges::none_of(sea_.openEnds, [&](glm::dvec2 end) { return contains(face, end); });
    }

    Box2 box_;
    std::vector<PlanLine> lines_;
    std::map<Edge, double> directed_;  ///< lengths by their ends
    Sea sea_;
};

}  // namespace

Sea findSea(const std::vector<CoastLine>& coast, const Box2& box) { return SeaFinder(coast, box).find(); }

}  // namespace noonmark
