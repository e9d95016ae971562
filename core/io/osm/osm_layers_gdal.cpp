#include "core/io/osm/osm_layers.h"

#include <gdal_priv.h>
#include <ogr_api.h>
#include <ogr_geometry.h>
#include <ogrsf_frmts.h>
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>
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

namespace {

constexpr const char* sourceItem = "SOURCE";
constexpr const char* sourceName = "OpenStreetMap";
constexpr const char* sideItems[] = {"WEST", "SOUTH", "EAST", "NORTH"};  // of the box, OpenStreetMap's units

// A layer in memory takes any feature, unless memory runs out.
void require(OGRErr result) {
    if (result != OGRERR_NONE) throw std::bad_alloc();
}

double degrees(std::int32_t units) { return units / 1e7; }

std::unique_ptr<OGRLinearRing> makeRing(const std::vector<LonLat>& places) {
    auto ring = std::make_unique<OGRLinearRing>();
    ring->setNumPoints(int(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i)
        ring->setPoint(int(i), places[i].lonDeg, places[i].latDeg);
    ring->closeRings();
    return ring;
}

std::unique_ptr<OGRGeometry> makePolygons(const std::vector<LonLatPolygon>& polygons) {
    auto all = std::make_unique<OGRMultiPolygon>();
    for (const LonLatPolygon& rings : polygons) {
        auto polygon = std::make_unique<OGRPolygon>();
        for (const auto& ring : rings) polygon->addRingDirectly(makeRing(ring).release());
        all->addGeometryDirectly(polygon.release());
    }
    return all;
}

std::unique_ptr<OGRGeometry> makeLine(const std::vector<OsmPoint>& points) {
    auto line = std::make_unique<OGRLineString>();
    line->setNumPoints(int(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        line->setPoint(int(i), degrees(points[i].lon), degrees(points[i].lat));
    return line;
}

/// Fills the layers of a dataset in memory.
class LayerFiller {
public:
    LayerFiller(GDALDataset& dataset, const OsmSelection& selection)
        : dataset_(dataset), selection_(selection) {
        system_.SetWellKnownGeogCS("WGS84");
        system_.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    }

    void addPoints(const std::vector<OsmNode>& points) {
        OGRLayer& layer = makeLayer("points", wkbPoint, {"osm_id"});
        for (const OsmNode& node : points)
            add(layer, "osm_id", node.id, node.tags,
                std::make_unique<OGRPoint>(degrees(node.point.lon), degrees(node.point.lat)));
    }

    void addLines(const std::vector<OsmWay>& ways) {
        OGRLayer& layer = makeLayer("lines", wkbLineString, {"osm_id"});
        for (const OsmWay& way : ways)
            if (way.line) add(layer, "osm_id", way.id, way.tags, makeLine(way.points));
    }

    void addAreas(const OsmMap& map, const std::stop_token& stop) {
        OGRLayer& layer = makeLayer("multipolygons", wkbMultiPolygon, {"osm_id", "osm_way_id"});
        forEachOsmArea(
            map,
            [&](const OsmArea& area) {
                add(layer, area.relation ? "osm_id" : "osm_way_id", area.id, area.tags,
                    makePolygons(area.polygons));
            },
            stop);
    }

private:
    OGRLayer& makeLayer(const char* name, OGRwkbGeometryType type, const std::vector<std::string>& ids) {
        OGRLayer* layer = dataset_.CreateLayer(name, &system_, type, nullptr);
        for (const auto* fields : {&ids, &selection_.keys})
            for (const std::string& field : *fields) {
                OGRFieldDefn definition(field.c_str(), OFTString);
                require(layer->CreateField(&definition));
            }
        return *layer;
    }

    static void add(OGRLayer& layer, const char* idField, std::int64_t id, const OsmTags& tags,
                    std::unique_ptr<OGRGeometry> shape) {
        OGRFeature feature(layer.GetLayerDefn());
        feature.SetField(idField, std::to_string(id).c_str());
        for (const auto& [key, value] : tags) feature.SetField(key.c_str(), value.c_str());
        feature.SetGeometryDirectly(shape.release());
        require(layer.CreateFeature(&feature));
    }

    GDALDataset& dataset_;
    const OsmSelection& selection_;
    OGRSpatialReference system_;
};

void noteBox(GDALDataset& dataset, const OsmBox& box) {
    const std::int32_t sides[] = {box.low.lon, box.low.lat, box.high.lon, box.high.lat};
    for (std::size_t i = 0; i < std::size(sides); ++i)
        dataset.SetMetadataItem(sideItems[i], std::to_string(sides[i]).c_str());
}

}  // namespace

Result<DatasetPointer> readOsmLayers(const std::filesystem::path& file, OsmFormat format,
                                     const OsmSelection& selection, Progress& progress,
                                     const std::stop_token& stop) {
    const auto map = readOsmMap(file, format, selection, progress, stop);
    if (!map) return tl::make_unexpected(map.error());
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("Memory");
    if (driver == nullptr) throw std::runtime_error("GDAL was built without its driver for memory");
    DatasetPointer dataset(driver->Create("", 0, 0, 0, GDT_Unknown, nullptr));
    dataset->SetMetadataItem(sourceItem, sourceName);
    if (map->box) noteBox(*dataset, *map->box);
    LayerFiller filler(*dataset, selection);
    if (!selection.pointKeys.empty()) filler.addPoints(map->points);
    if (!selection.lineKeys.empty()) filler.addLines(map->ways);
    filler.addAreas(*map, stop);
    if (stop.stop_requested()) return cancelled();
    return dataset;
}

std::optional<LonLatBox> findOsmBox(GDALDataset& dataset) {
    LonLatBox box;
    double* const sides[] = {&box.westDeg, &box.southDeg, &box.eastDeg, &box.northDeg};
    for (std::size_t i = 0; i < std::size(sides); ++i) {
        const char* text = dataset.GetMetadataItem(sideItems[i]);
        if (text == nullptr) return std::nullopt;
        *sides[i] = degrees(std::int32_t(std::strtol(text, nullptr, 10)));
    }
    return box;
}

bool isFromOsm(GDALDataset& dataset) {
    const char* source = dataset.GetMetadataItem(sourceItem);
    return std::string_view(dataset.GetDriverName()) == "Memory" && source != nullptr &&
           std::string_view(source) == sourceName;
}

}  // namespace noonmark
