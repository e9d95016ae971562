#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include "core/base/gdal_calls.h"
#include "core/io/files/write_text.h"
#include "core/study/tile_tasks/plan/task_plan.h"

namespace noonmark {

namespace {

Box2 boxOf(const Grid& grid) {
    return {{float(grid.westM), float(grid.southM)}, {float(grid.eastM()), float(grid.northM())}};
}

// Straight in the local plane; at the size of a tile the difference from a straight line on the map is
// millimetres.
OGRPolygon polygonOf(const Box2& box, const Frame& frame) {
    OGRLinearRing ring;
    for (const glm::dvec2 corner : {glm::dvec2(box.low), glm::dvec2(box.high.x, box.low.y),
                                    glm::dvec2(box.high), glm::dvec2(box.low.x, box.high.y)}) {
        const LonLat place = frame.lonLatFromLocal(corner);
        ring.addPoint(place.lonDeg, place.latDeg);
    }
    ring.closeRings();
    OGRPolygon polygon;
    polygon.addRing(&ring);
    return polygon;
}

void addFields(OGRLayer& layer) {
    for (const auto& [name, type] : {std::pair("task", OFTInteger64), std::pair("district", OFTInteger64),
                                     std::pair("tile", OFTInteger64), std::pair("buildings", OFTInteger64),
                                     std::pair("seconds", OFTReal), std::pair("memory_mb", OFTReal),
                                     std::pair("content_hash", OFTString)}) {
        OGRFieldDefn field(name, type);
        layer.CreateField(&field);
    }
}

bool addTile(OGRLayer& layer, const PlannedTile& tile, const OGRPolygon& polygon) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField("task", GIntBig(tile.task));
    feature.SetField("district", GIntBig(tile.district));
    feature.SetField("tile", GIntBig(tile.number));
    feature.SetField("buildings", GIntBig(tile.buildings));
    feature.SetField("seconds", tile.seconds);
    feature.SetField("memory_mb", tile.memoryBytes / 1e6);
    feature.SetField("content_hash", tile.contentHash.c_str());
    feature.SetGeometry(&polygon);
    return layer.CreateFeature(&feature) == OGRERR_NONE;
}

bool writeLayer(GDALDataset& dataset, const TaskPlan& plan, const char* name, bool halos) {
    OGRSpatialReference degrees;
    degrees.SetWellKnownGeogCS("WGS84");
    degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer* layer = dataset.CreateLayer(name, &degrees, wkbPolygon, nullptr);
    if (layer == nullptr) return false;
    addFields(*layer);
    for (const PlannedTile& tile : plan.tiles) {
        const District& district = plan.districts.at(tile.district);
        const Box2 box = halos ? tile.reads : boxOf(district.tiles.tile(tile.number));
        if (!addTile(*layer, tile, polygonOf(box, district.frame))) return false;
    }
    return true;
}

}  // namespace

Result<void> writeTileIndex(const std::filesystem::path& file, const TaskPlan& plan) {
    const GdalCalls calls;
    PendingFile pending(file);
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    GDALDatasetUniquePtr dataset(
        driver == nullptr ? nullptr : driver->Create(pending.path().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    bool sound = dataset != nullptr && dataset->StartTransaction() == OGRERR_NONE;
    sound = sound && writeLayer(*dataset, plan, "tiles", false) && writeLayer(*dataset, plan, "halos", true);
    sound = sound && dataset->CommitTransaction() == OGRERR_NONE;
    dataset.reset();
    if (!sound || calls.failed())
        return limitReached("The index of tiles could not be written: " + calls.why(), file.string(),
                            "Check that the folder is writable and has space");
    return pending.commit();
}

}  // namespace noonmark
