#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "core/base/gdal_calls.h"
#include "tests/fuzz/file_geodatabase.h"
#include "tests/fuzz/require.h"

namespace noonmark::tests {

namespace {

void addSquare(OGRLayer& layer, double westM, double sideM, const char* name, double heightM) {
    OGRLinearRing ring;
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}})
        ring.addPoint(391800 + westM + x * sideM, 5819500 + y * sideM);
    OGRPolygon polygon;
    polygon.addRing(&ring);
    OGRMultiPolygon all;
    all.addGeometry(&polygon);
    const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer.GetLayerDefn()));
    feature->SetGeometry(&all);
    feature->SetField("name", name);
    feature->SetField("height", heightM);
    require(layer.CreateFeature(feature.get()) == OGRERR_NONE, "a feature is written");
}

OGRLayer& addLayer(GDALDataset& dataset, const char* name) {
    OGRSpatialReference crs;
    crs.importFromEPSG(25833);
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer* layer = dataset.CreateLayer(name, &crs, wkbMultiPolygon, nullptr);
    require(layer != nullptr, "a layer is made");
    for (auto [field, type] : {std::pair("name", OFTString), std::pair("height", OFTReal)}) {
        OGRFieldDefn definition(field, type);
        layer->CreateField(&definition);
    }
    return *layer;
}

}  // namespace

void writeFileGeodatabase(const std::filesystem::path& folder) {
    const GdalCalls calls;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("OpenFileGDB");
    require(driver != nullptr, "GDAL knows file geodatabases");
    const GDALDatasetUniquePtr made(driver->Create(folder.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    require(made != nullptr, "GDAL writes file geodatabases");
    OGRLayer& buildings = addLayer(*made, "buildings");
    for (int i = 0; i < 3; ++i) addSquare(buildings, 30 * i, 20, "house", 9 + i);
    addSquare(addLayer(*made, "plots"), -10, 200, "plot", 0);
}

}  // namespace noonmark::tests
