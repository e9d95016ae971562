#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "core/base/gdal_calls.h"
#include "core/city/terrain/building_ground.h"
#include "core/city/trees/tree.h"
#include "core/geo/frame.h"
#include "core/geo/lon_lat.h"
#include "core/io/files/write_text.h"
#include "core/io/styles/qgis_style.h"
#include "core/io/write_city.h"

namespace noonmark {

namespace {

struct FieldColumn {
    const char* name;
    OGRFieldType type;
};
constexpr FieldColumn columns[] = {
    {"building_id", OFTString},    {"source_id", OFTString},     {"name", OFTString},
    {"status", OFTString},         {"height", OFTReal},          {"min_height", OFTReal},
    {"ground_elevation", OFTReal}, {"height_source", OFTString}, {"hangs", OFTInteger},
};

using BuildingColumns = std::vector<BuildingColumn>;

OGRLayer* createLayer(GDALDataset& dataset, const BuildingColumns& figures) {
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer* layer = dataset.CreateLayer("buildings", &wgs84, wkbPolygon, nullptr);
    if (layer == nullptr) return nullptr;
    for (const FieldColumn& column : columns) {
        OGRFieldDefn field(column.name, column.type);
        if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
    }
    for (const BuildingColumn& column : figures) {
        OGRFieldDefn field(column.name.c_str(), OFTReal);
        if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
    }
    return layer;
}

// A building on the antimeridian is written in one piece, with longitudes beyond 180.
void addRing(OGRPolygon& polygon, const Ring& ring, const Frame& frame, double nearDeg) {
    OGRLinearRing line;
    for (const glm::vec2 point : ring) {
        const LonLat place = frame.lonLatFromLocal(glm::dvec2(point));
        line.addPoint(wrapLongitudeNear(place.lonDeg, nearDeg), place.latDeg);
    }
    line.closeRings();
    polygon.addRing(&line);
}

OGRPolygon polygonOf(const Footprint& footprint, const Frame& frame) {
    OGRPolygon polygon;
    const double nearDeg = frame.lonLatFromLocal(glm::dvec2(footprint.outer.front())).lonDeg;
    addRing(polygon, footprint.outer, frame, nearDeg);
    for (const Ring& hole : footprint.holes) addRing(polygon, hole, frame, nearDeg);
    return polygon;
}

// Writes the buildings one by one and collects what cannot be written unchanged.
class PartWriter {
public:
    PartWriter(OGRLayer& layer, const City& city, const BuildingColumns& figures)
        : layer_(layer), city_(city), figures_(figures) {}

    bool write(const Building& building, std::size_t index) {
        index_ = index;
        const std::string id = idFor(building);
        const float ground = findGroundUnder(building, city_);
        const Box2 box = bounds(building);
        // Readers lower an elevation by the drop when the building is set on terrain.
        dropM_ = city_.terrain ? earthDropM(glm::dvec2(box.low + box.high) / 2.0) : 0;
        return std::ranges::all_of(
            building.parts, [&](const Part& part) { return write(building, id, part, double(ground)); });
    }

    Warnings warnings;

private:
    bool write(const Building& building, const std::string& id, const Part& part, double groundM) {
        OGRFeature feature(layer_.GetLayerDefn());
        feature.SetField("building_id", id.c_str());
        feature.SetField("source_id", part.sourceId.c_str());
        feature.SetField("name", building.name.c_str());
        feature.SetField("status", building.status.c_str());
        feature.SetField("height", part.topM - groundM);
        feature.SetField("min_height", part.bottomM - groundM);
        // A flat city at 0 has no known elevation; writing one would bury it under a terrain that is opened
        // with it.
        const double elevation = city_.frame.originElevationM() + groundM + dropM_;
        if (city_.terrain || elevation != 0) feature.SetField("ground_elevation", elevation);
        feature.SetField("height_source", std::string(nameOf(part.heightSource)).c_str());
        feature.SetField("hangs", part.isOverhanging ? 1 : 0);
        for (const BuildingColumn& column : figures_)
            feature.SetField(column.name.c_str(), column.values[index_]);
        const OGRPolygon polygon = polygonOf(part.footprint, city_.frame);
        feature.SetGeometry(&polygon);
        if (part.mesh)
            warnings.push_back({WarningKind::leftOut,
                                "the shape of a mesh; it was written as the prism of its outline",
                                part.sourceId});
        return layer_.CreateFeature(&feature) == OGRERR_NONE;
    }

    // Two buildings with the same source id (from two files, for instance) must stay separate when they are
    // read again.
    std::string idFor(const Building& building) {
        const std::string own = building.sourceId.empty() ? "building" : building.sourceId;
        std::string id = own;
        for (int copy = 2; !ids_.insert(id).second; ++copy) id = fmt::format("{} ({})", own, copy);
        return id;
    }

    OGRLayer& layer_;
    const City& city_;
    const BuildingColumns& figures_;
    std::size_t index_ = 0;  // index of the current building
    double dropM_ = 0;       // of the earth's surface at it
    std::unordered_set<std::string> ids_;
};

std::optional<Warnings> writeAll(GDALDataset& dataset, const City& city, const BuildingColumns& figures,
                                 const LayerStyle& style) {
    if (dataset.StartTransaction() != OGRERR_NONE)
        return std::nullopt;  // a single transaction: 40,000 parts in under a second
    OGRLayer* layer = createLayer(dataset, figures);
    if (layer == nullptr) return std::nullopt;
    PartWriter writer(*layer, city, figures);
    for (std::size_t i = 0; i < city.buildings.size(); ++i)
        if (!writer.write(*city.buildings[i], i)) return std::nullopt;
    writeLayerStyle(dataset, *layer, style);
    if (dataset.CommitTransaction() != OGRERR_NONE) return std::nullopt;
    return std::move(writer.warnings);
}

}  // namespace

Result<Warnings> writeCityGeoPackage(const std::filesystem::path& file, const City& city,
                                     const std::vector<BuildingColumn>& figures, const LayerStyle& style) {
    const GdalCalls calls;
    PendingFile pending(file);
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    GDALDatasetUniquePtr dataset(
        driver != nullptr ? driver->Create(pending.path().c_str(), 0, 0, 0, GDT_Unknown, nullptr) : nullptr);
    std::optional<Warnings> warnings;
    if (dataset) warnings = writeAll(*dataset, city, figures, style);
    dataset.reset();
    if (!warnings || calls.failed())
        return failure("The GeoPackage could not be written: " + calls.why(), file.string(),
                       "Check that the folder exists, is writable and has space");
    if (auto named = pending.commit(); !named) return tl::make_unexpected(named.error());
    if (city.terrain)
        warnings->push_back(
            {WarningKind::leftOut, "terrain; keep its raster and read both files", file.filename().string()});
    std::ranges::move(warnOfTrees(city.trees, "a GeoPackage of buildings does not hold them"),
                      std::back_inserter(*warnings));
    return *std::move(warnings);
}

}  // namespace noonmark
