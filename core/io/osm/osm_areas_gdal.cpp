#include "core/io/osm/osm_areas.h"

#include <ogr_api.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <unordered_set>
#include <utility>

#include "core/io/footprints/ogr_polygons.h"

namespace noonmark {

namespace {

LonLat lonLatOf(OsmPoint point) { return {point.lon / 1e7, point.lat / 1e7}; }

void setPoints(OGRLineString& line, const std::vector<OsmPoint>& points) {
    line.setNumPoints(int(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        line.setPoint(int(i), lonLatOf(points[i]).lonDeg, lonLatOf(points[i]).latDeg);
}

bool isClosed(const OGRLinearRing& ring) {
    const int last = ring.getNumPoints() - 1;
    return last >= 3 && ring.getX(0) == ring.getX(last) && ring.getY(0) == ring.getY(last);
}

// Ways joined at equal ends, each continued by the first way that begins or ends where it does. GDAL joins
// lines too, but compares each with every other: it would take seconds for the many thousands of a hostile
// relation.
std::vector<std::vector<OsmPoint>> joinEnds(const std::vector<const OsmWay*>& ways) {
    const auto key = [](OsmPoint point) { return std::pair(point.lon, point.lat); };
    std::multimap<std::pair<std::int32_t, std::int32_t>, std::size_t> ends;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        ends.emplace(key(ways[i]->points.front()), i);
        ends.emplace(key(ways[i]->points.back()), i);
    }
    std::vector<bool> used(ways.size(), false);
    std::vector<std::vector<OsmPoint>> chains;
    const auto takeUnused = [&](OsmPoint end) -> const OsmWay* {
        auto [place, last] = ends.equal_range(key(end));
        while (place != last && used[place->second]) place = ends.erase(place);
        if (place == last) return nullptr;
        used[place->second] = true;
        return ways[place->second];
    };
    for (std::size_t i = 0; i < ways.size(); ++i) {
        if (used[i]) continue;
        used[i] = true;
        std::vector<OsmPoint>& chain = chains.emplace_back(ways[i]->points);
        while (chain.front() != chain.back()) {
            const OsmWay* next = takeUnused(chain.back());
            if (next == nullptr) break;
            if (next->points.front() == chain.back())
                chain.insert(chain.end(), next->points.begin() + 1, next->points.end());
            else
                chain.insert(chain.end(), next->points.rbegin() + 1, next->points.rend());
        }
    }
    return chains;
}

/// Rings of one relation, given to GDAL as polygons.
class Rings {
public:
    void add(const OsmWay& way) {
        if (way.points.front() == way.points.back()) {
            auto ring = std::make_unique<OGRLinearRing>();
            setPoints(*ring, way.points);
            addRing(std::move(ring));
        } else {
            open_.push_back(&way);
        }
    }

    std::vector<LonLatPolygon> polygons() && {
        joinLines();
        std::vector<OGRGeometry*> given;
        for (auto& polygon : polygons_) given.push_back(polygon.release());
        if (given.empty()) return {};
        const char* options[] = {"METHOD=DEFAULT", nullptr};
        int valid = FALSE;
        const std::unique_ptr<OGRGeometry> organised(
            OGRGeometryFactory::organizePolygons(given.data(), int(given.size()), &valid, options));
        if (!organised) return {};
        const OGRwkbGeometryType type = organised->getGeometryType();
        return type == wkbPolygon || type == wkbMultiPolygon ? toLonLat(readPolygons(*organised))
                                                             : std::vector<LonLatPolygon>();
    }

private:
    void addRing(std::unique_ptr<OGRLinearRing> ring) {
        auto polygon = std::make_unique<OGRPolygon>();
        polygon->addRingDirectly(ring.release());
        polygons_.push_back(std::move(polygon));
    }

    void addLine(const std::vector<OsmPoint>& points) {
        auto line = std::make_unique<OGRLineString>();
        setPoints(*line, points);
        lines_.addGeometryDirectly(line.release());
    }

    // Ways that are not closed are joined to rings at their ends.
    void joinLines() {
        constexpr std::size_t few = 1000;  // GDAL joins them within milliseconds
        if (open_.size() > few)
            for (const auto& chain : joinEnds(open_)) addLine(chain);
        else
            for (const OsmWay* way : open_) addLine(way->points);
        if (lines_.getNumGeometries() == 0) return;
        const std::unique_ptr<OGRGeometry> joined(OGRGeometry::FromHandle(
            OGRBuildPolygonFromEdges(OGRGeometry::ToHandle(&lines_), TRUE, FALSE, 0, nullptr)));
        if (!joined || joined->getGeometryType() != wkbPolygon) return;
        for (const OGRLinearRing* ring : *joined->toPolygon())
            if (isClosed(*ring)) addRing(std::unique_ptr<OGRLinearRing>(ring->clone()));
    }

    static std::vector<LonLatPolygon> toLonLat(const std::vector<CrsPolygon>& polygons) {
        std::vector<LonLatPolygon> all;
        for (const CrsPolygon& polygon : polygons)
            for (LonLatPolygon& rings = all.emplace_back(); const auto& ring : polygon) {
                auto& places = rings.emplace_back();
                for (const glm::dvec2 point : ring) places.push_back({point.x, point.y});
            }
        return all;
    }

    std::vector<const OsmWay*> open_;
    OGRMultiLineString lines_;
    std::vector<std::unique_ptr<OGRPolygon>> polygons_;
};

/// Hands out areas, and remembers which ways relations stand for.
class Areas {
public:
    Areas(const OsmMap& map, const std::function<void(OsmArea)>& take) : map_(map), take_(take) {}

    void takeRelation(const OsmRelation& relation) {
        std::vector<const OsmWay*> ways;
        for (const OsmMember& member : relation.members)
            if (const OsmWay* way = findWay(member.way); way != nullptr)
                ways.push_back(way);
            else
                return;
        Rings rings;
        const OsmWay* describing = nullptr;
        for (std::size_t i = 0; i < ways.size(); ++i) {
            rings.add(*ways[i]);
            if (!relation.members[i].outer) continue;
            if (ways[i]->tagged && describing == nullptr) describing = ways[i];
            if (ways[i]->points.front() == ways[i]->points.back()) replaced_.insert(ways[i]->id);
        }
        const bool described = !relation.tagged && describing != nullptr;
        if (auto polygons = std::move(rings).polygons(); !polygons.empty())
            take_({true, relation.id, described ? describing->tags : relation.tags, std::move(polygons)});
    }

    void takeWay(const OsmWay& way) {
        if (!way.tagged || replaced_.contains(way.id)) return;
        std::vector<LonLat> ring;
        for (const OsmPoint point : way.points) ring.push_back(lonLatOf(point));
        take_({false, way.id, way.tags, {{std::move(ring)}}});
    }

private:
    [[nodiscard]] const OsmWay* findWay(std::int64_t id) const {
        const auto found = std::ranges::lower_bound(map_.ways, id, {}, &OsmWay::id);
        return found != map_.ways.end() && found->id == id ? &*found : nullptr;
    }

    const OsmMap& map_;
    const std::function<void(OsmArea)>& take_;
    std::unordered_set<std::int64_t> replaced_;
};

}  // namespace

void forEachOsmArea(const OsmMap& map, const std::function<void(OsmArea)>& take,
                    const std::stop_token& stop) {
    Areas areas(map, take);
    for (const OsmRelation& relation : map.relations) {
        if (stop.stop_requested()) return;
        areas.takeRelation(relation);
    }
    for (const OsmWay& way : map.ways) {
        if (stop.stop_requested()) return;
        areas.takeWay(way);
    }
}

}  // namespace noonmark
