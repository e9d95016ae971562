#include "core/io/osm/osm_layers.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cstdlib>
#include <iterator>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>

#include "core/io/osm/osm_areas.h"

namespace noonmark {

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
