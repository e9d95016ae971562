#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "core/base/gdal_calls.h"
#include "core/base/json_number.h"
#include "core/io/elements/write_elements.h"
#include "core/io/styles/qgis_style.h"

namespace noonmark {

namespace {

OGRFieldType fieldTypeOf(const ElementValue& value) {
    if (std::holds_alternative<double>(value)) return OFTReal;
    return std::holds_alternative<std::int64_t>(value) ? OFTInteger64 : OFTString;
}

void setElementValue(OGRFeature& feature, int field, const ElementValue& value, int decimals) {
    if (const auto* text = std::get_if<std::string>(&value))
        feature.SetField(field, text->c_str());
    else if (const auto* whole = std::get_if<std::int64_t>(&value))
        feature.SetField(field, GIntBig(*whole));
    else if (const auto* number = std::get_if<double>(&value); number != nullptr && std::isfinite(*number))
        feature.SetField(field, roundAsText(*number, decimals) + 0.0);  // the sum of zeros has no sign
}

/// A layer as it is written: how its rows become shapes.
struct WrittenLayer {
    const char* name;
    const char* description;
    OGRwkbGeometryType type;
    std::function<std::unique_ptr<OGRGeometry>(std::size_t row)> shape;
    LayerStyle style = {};
};

OGRLayer* createTableLayer(GDALDataset& dataset, const WrittenLayer& written, const ElementTable& table) {
    OGRSpatialReference system;
    system.importFromEPSG(4326);
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    CPLStringList options;
    options.SetNameValue("FID", "fid");
    options.SetNameValue("DESCRIPTION", written.description);
    OGRLayer* layer = dataset.CreateLayer(written.name, &system, written.type, options.List());
    if (layer == nullptr) return nullptr;
    for (const ElementColumn& column : table.columns) {
        OGRFieldDefn field(column.name.c_str(), fieldTypeOf(column.kind));
        if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
    }
    return layer;
}

bool writeRow(OGRLayer& layer, const ElementTable& table, std::size_t row,
              std::unique_ptr<OGRGeometry> shape) {
    OGRFeature feature(layer.GetLayerDefn());
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        setElementValue(feature, int(i), table.rows[row][i], table.columns[i].decimals);
    feature.SetGeometryDirectly(shape.release());
    return layer.CreateFeature(&feature) == OGRERR_NONE;
}

bool writeTable(GDALDataset& dataset, const WrittenLayer& written, const ElementTable& table) {
    if (dataset.StartTransaction() != OGRERR_NONE) return false;
    OGRLayer* layer = createTableLayer(dataset, written, table);
    if (layer == nullptr) return false;
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        if (!writeRow(*layer, table, i, written.shape(i))) return false;
    writeLayerStyle(dataset, *layer, written.style);
    return dataset.CommitTransaction() == OGRERR_NONE;
}

Result<void> writeGeoPackage(const std::filesystem::path& file, const WrittenLayer& layer,
                             const ElementTable& table) {
    const GdalCalls calls;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    GDALDatasetUniquePtr dataset(
        driver == nullptr ? nullptr : driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    const bool written = dataset && writeTable(*dataset, layer, table);
    dataset.reset();
    if (written && !calls.failed()) return {};
    return failure("The GeoPackage could not be written: " + calls.why(), file.string(),
                   "Check that the folder exists, is writable and has space");
}

std::unique_ptr<OGRLinearRing> makeRing(const std::vector<glm::vec2>& points, const Frame& frame) {
    auto ring = std::make_unique<OGRLinearRing>();
    for (const glm::vec2& point : points) {
        const LonLat at = frame.lonLatFromLocal(glm::dvec2(point));
        ring->addPoint(at.lonDeg, at.latDeg);
    }
    ring->closeRings();
    return ring;
}

std::unique_ptr<OGRGeometry> makeMultiPolygon(const Place& place, const Frame& frame) {
    auto shape = std::make_unique<OGRMultiPolygon>();
    for (const Footprint& footprint : place.polygons) {
        auto polygon = std::make_unique<OGRPolygon>();
        polygon->addRingDirectly(makeRing(footprint.outer, frame).release());
        for (const auto& hole : footprint.holes) polygon->addRingDirectly(makeRing(hole, frame).release());
        shape->addGeometryDirectly(polygon.release());
    }
    return shape;
}

}  // namespace

Result<void> writeElementsGeoPackage(const std::filesystem::path& file, const ElementTable& table,
                                     const LayerStyle& style) {
    const auto shape = [&](std::size_t row) {
        const glm::dvec3 place = table.places[row];
        return std::make_unique<OGRPoint>(place.x, place.y, place.z);
    };
    return writeGeoPackage(
        file,
        {"elements", "Points where sunlight was measured. z: metres in the vertical datum of the city's data",
         wkbPoint25D, shape, style},
        table);
}

Result<void> writePlacesGeoPackage(const std::filesystem::path& file, const Frame& frame,
                                   const std::vector<Place>& places, const ElementTable& table,
                                   const LayerStyle& style) {
    return writePolygonsGeoPackage(file, frame, {"places", "Places and their sun"}, places, table, style);
}

Result<void> writePolygonsGeoPackage(const std::filesystem::path& file, const Frame& frame,
                                     const NamedLayer& layer, const std::vector<Place>& polygons,
                                     const ElementTable& table, const LayerStyle& style) {
    const auto shape = [&](std::size_t row) { return makeMultiPolygon(polygons[row], frame); };
    return writeGeoPackage(file, {layer.name, layer.description, wkbMultiPolygon, shape, style}, table);
}

}  // namespace noonmark
