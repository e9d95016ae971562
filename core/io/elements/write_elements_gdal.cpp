#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>

#include "core/base/gdal_calls.h"
#include "core/io/elements/write_elements.h"

namespace noonmark {

namespace {

OGRFieldType fieldTypeOf(const ElementValue& value) {
    if (std::holds_alternative<double>(value)) return OFTReal;
    return std::holds_alternative<std::int64_t>(value) ? OFTInteger64 : OFTString;
}

void setElementValue(OGRFeature& feature, int field, const ElementValue& value) {
    if (const auto* text = std::get_if<std::string>(&value))
        feature.SetField(field, text->c_str());
    else if (const auto* whole = std::get_if<std::int64_t>(&value))
        feature.SetField(field, GIntBig(*whole));
    else if (const auto* number = std::get_if<double>(&value); number != nullptr && std::isfinite(*number))
        feature.SetField(field, *number);
}

OGRLayer* createElementLayer(GDALDataset& dataset, const ElementTable& table) {
    OGRSpatialReference system;
    system.importFromEPSG(4326);
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    CPLStringList options;
    options.SetNameValue("FID", "fid");
    options.SetNameValue(
        "DESCRIPTION",
        "Points where sunlight was measured. z: metres in the vertical datum of the city's data");
    OGRLayer* layer = dataset.CreateLayer("elements", &system, wkbPoint25D, options.List());
    if (layer == nullptr) return nullptr;
    for (const ElementColumn& column : table.columns) {
        OGRFieldDefn field(column.name.c_str(), fieldTypeOf(column.kind));
        if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
    }
    return layer;
}

bool writeElement(OGRLayer& layer, const std::vector<ElementValue>& row, glm::dvec3 place) {
    OGRFeature feature(layer.GetLayerDefn());
    for (std::size_t i = 0; i < row.size(); ++i) setElementValue(feature, int(i), row[i]);
    feature.SetGeometryDirectly(new OGRPoint(place.x, place.y, place.z));
    return layer.CreateFeature(&feature) == OGRERR_NONE;
}

bool writeElementTable(GDALDataset& dataset, const ElementTable& table) {
    if (dataset.StartTransaction() != OGRERR_NONE) return false;
    OGRLayer* layer = createElementLayer(dataset, table);
    if (layer == nullptr) return false;
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        if (!writeElement(*layer, table.rows[i], table.places[i])) return false;
    return dataset.CommitTransaction() == OGRERR_NONE;
}

}  // namespace

Result<void> writeElementsGeoPackage(const std::filesystem::path& file, const ElementTable& table) {
    const GdalCalls calls;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    GDALDatasetUniquePtr dataset(
        driver == nullptr ? nullptr : driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    const bool written = dataset && writeElementTable(*dataset, table);
    dataset.reset();
    if (written && !calls.failed()) return {};
    return failure("The GeoPackage could not be written: " + calls.why(), file.string(),
                   "Check that the folder exists, is writable and has space");
}

}  // namespace noonmark
