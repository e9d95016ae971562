#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <array>
#include <fstream>
#include <iterator>
#include <vector>

#include "core/base/gdal_calls.h"
#include "core/io/write_city.h"
#include "core/io/write_raster.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/seeds.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {

namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

GDALDriver& driverNamed(const char* name) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(name);
    require(driver != nullptr, name);
    return *driver;
}

OGRSpatialReference degrees() {
    OGRSpatialReference crs;
    crs.SetWellKnownGeogCS("WGS84");
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return crs;
}

void addFeature(OGRLayer& layer, const char* wkt, double heightM, int levels) {
    OGRFeature feature(layer.GetLayerDefn());
    OGRGeometry* geometry = nullptr;
    OGRGeometryFactory::createFromWkt(wkt, nullptr, &geometry);
    feature.SetGeometryDirectly(geometry);
    feature.SetField("name", "house");
    feature.SetField("height", heightM);
    feature.SetField("levels", levels);
    require(layer.CreateFeature(&feature) == OGRERR_NONE, "a feature is written");
}

// Two buildings, one with a courtyard.
void writeBuildings(const fs::path& file, const char* driver) {
    GDALDatasetUniquePtr dataset(driverNamed(driver).Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    require(dataset != nullptr, driver);
    OGRSpatialReference crs = degrees();
    OGRLayer* layer = dataset->CreateLayer("buildings", &crs, wkbPolygon, nullptr);
    for (auto [name, type] :
         {std::pair("name", OFTString), std::pair("height", OFTReal), std::pair("levels", OFTInteger)}) {
        OGRFieldDefn field(name, type);
        layer->CreateField(&field);
    }
    addFeature(*layer, "POLYGON ((-73.98 40.75,-73.979 40.75,-73.979 40.751,-73.98 40.751,-73.98 40.75))",
               12.5, 4);
    addFeature(*layer,
               "POLYGON ((-73.978 40.75,-73.976 40.75,-73.976 40.752,-73.978 40.752,-73.978 40.75),"
               "(-73.9775 40.7505,-73.9775 40.7515,-73.9765 40.7515,-73.9765 40.7505,-73.9775 40.7505))",
               30, 9);
}

// In the format that fuzz_shapefile reads.
void writeShapefile(const SeedFolder& seeds) {
    const fs::path shp = seeds.file("shapefile.parts", "buildings.shp");
    writeBuildings(shp, "ESRI Shapefile");
    std::string lengths, bytes;
    for (const char* ending : {".shp", ".shx", ".dbf"}) {
        const std::string part = bytesOf(fs::path(shp).replace_extension(ending));
        put(lengths, std::uint16_t(part.size()));
        bytes += part;
    }
    seeds.write("shapefile", "buildings", lengths + bytes);
    seeds.write("shapefile", "with-prj", lengths + bytes + bytesOf(fs::path(shp).replace_extension(".prj")));
    fs::remove_all(shp.parent_path());
}

void writeGeoTiff(const fs::path& file, GDALDataType type, std::array<double, 6> place, int epsg,
                  const char* compression, float stepM = 0) {
    constexpr int columns = 12, rows = 9;
    CPLStringList options;
    options.AddNameValue("COMPRESS", compression);
    GDALDatasetUniquePtr raster(
        driverNamed("GTiff").Create(file.c_str(), columns, rows, 1, type, options.List()));
    require(raster != nullptr, "a GeoTIFF is written");
    raster->SetGeoTransform(place.data());
    OGRSpatialReference crs;
    crs.importFromEPSG(epsg);
    raster->SetSpatialRef(&crs);
    std::vector<float> elevations;
    for (int i = 0; i < columns * rows; ++i)
        elevations.push_back(float(i % 7) + 2 + (i % columns > 5 ? stepM : 0));
    raster->GetRasterBand(1)->SetNoDataValue(-9999);
    require(raster->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, columns, rows, elevations.data(), columns,
                                               rows, GDT_Float32, 0, 0) == CE_None,
            "elevations are written");
}

void writeTerrains(const SeedFolder& seeds) {
    const auto file = [&](const char* name) { return seeds.file("terrain_geotiff", name); };
    writeGeoTiff(file("metres.tif"), GDT_Float32, {586000, 10, 0, 4512000, 0, -10}, 26918, "NONE");
    writeGeoTiff(file("whole.tif"), GDT_Int16, {586000, 10, 0, 4512000, 0, -10}, 26918, "NONE");
    writeGeoTiff(file("degrees.tif"), GDT_Float32, {-73.98, 1e-4, 0, 40.76, 0, -1e-4}, 4326, "NONE");
    writeGeoTiff(file("askew.tif"), GDT_Float64, {586000, 9, 3, 4512000, 3, -9}, 26918, "NONE");
    writeGeoTiff(file("packed.tif"), GDT_Float32, {586000, 10, 0, 4512000, 0, -10}, 26918, "DEFLATE");
    writeGeoTiff(file("feet.tif"), GDT_Byte, {987000, 30, 0, 219000, 0, -30}, 2263, "LZW");
}

// In the format that fuzz_survey reads: a step of 9 m in the surface.
void writeSurveys(const SeedFolder& seeds) {
    constexpr std::array place{586000.0, 2.0, 0.0, 4512000.0, 0.0, -2.0};
    for (const auto& [name, type] : {std::pair("metres", GDT_Float32), std::pair("whole", GDT_Int16)}) {
        const fs::path dsm = seeds.file("survey.parts", "dsm.tif"),
                       dtm = seeds.file("survey.parts", "dtm.tif");
        writeGeoTiff(dsm, type, place, 26918, "NONE", 9);
        writeGeoTiff(dtm, type, place, 26918, "NONE");
        std::string bytes;
        put(bytes, std::uint16_t(fs::file_size(dsm)));
        seeds.write("survey", name, bytes + bytesOf(dsm) + bytesOf(dtm));
    }
    fs::remove_all(seeds.path / "survey.parts");
}

void writeCanopies(const SeedFolder& seeds) {
    const auto file = [&](const char* name) { return seeds.file("canopy_geotiff", name); };
    writeGeoTiff(file("metres.tif"), GDT_Float32, {586000, 1, 0, 4512000, 0, -1}, 26918, "NONE");
    writeGeoTiff(file("whole.tif"), GDT_Byte, {586000, 2, 0, 4512000, 0, -2}, 26918, "LZW");
    writeGeoTiff(file("degrees.tif"), GDT_Float64, {-73.98, 1e-5, 0, 40.76, 0, -1e-5}, 4326, "NONE");
    writeGeoTiff(file("packed.tif"), GDT_Int16, {586000, 1, 0.2, 4512000, 0.2, -1}, 26918, "DEFLATE");
}

void writeMap(const SeedFolder& seeds) {
    const Grid grid{0, 0, 2, 12, 9};
    const std::vector<float> values(grid.size(), 1.5F);
    const auto written = noonmark::writeGeoTiff(seeds.file("map_geotiff", "map.tif"), Frame({-73.98, 40.75}),
                                                grid, {{"gross shadow", "min/day", &values}});
    require(written.has_value(), "a map is written");
    writeGeoTiff(seeds.file("map_geotiff", "plain.tif"), GDT_Float32, {0, 2, 0, 18, 0, -2}, 26918, "NONE");
}

// Colours as three bands, with a fourth of transparency, and as one with a table.
void writePicture(const fs::path& file, int bands, const char* compression) {
    constexpr int columns = 12, rows = 9;
    CPLStringList options;
    options.AddNameValue("COMPRESS", compression);
    GDALDatasetUniquePtr picture(
        driverNamed("GTiff").Create(file.c_str(), columns, rows, bands, GDT_Byte, options.List()));
    require(picture != nullptr, "a picture is written");
    std::array<double, 6> place{-73.9805, 1e-4, 0, 40.7505, 0, -1e-4};
    picture->SetGeoTransform(place.data());
    OGRSpatialReference crs = degrees();
    picture->SetSpatialRef(&crs);
    GDALColorTable colours;
    for (int i = 0; i < 7; ++i) {
        const GDALColorEntry entry{short(30 * i), short(200 - 20 * i), 90, 255};
        colours.SetColorEntry(i, &entry);
    }
    if (bands == 1) picture->GetRasterBand(1)->SetColorTable(&colours);
    std::vector<std::uint8_t> values;
    for (int i = 0; i < columns * rows * bands; ++i) values.push_back(std::uint8_t(i % 7));
    require(picture->RasterIO(GF_Write, 0, 0, columns, rows, values.data(), columns, rows, GDT_Byte, bands,
                              nullptr, 0, 0, 0) == CE_None,
            "colours are written");
}

void writePictures(const SeedFolder& seeds) {
    const auto file = [&](const char* name) { return seeds.file("ground_picture", name); };
    writePicture(file("plain.tif"), 3, "NONE");
    writePicture(file("clear.tif"), 4, "LZW");
    writePicture(file("table.tif"), 1, "NONE");
    writePicture(file("packed.tif"), 3, "DEFLATE");
}

}  // namespace

void makeGdalSeeds(const SeedFolder& seeds) {
    const GdalCalls calls;
    writeBuildings(seeds.file("flatgeobuf", "buildings.fgb"), "FlatGeobuf");
    writeBuildings(seeds.file("geopackage_bytes", "gdal.gpkg"), "GPKG");
    writeBuildings(seeds.file("xml_map", "buildings.kml"), "KML");
    writeBuildings(seeds.file("xml_map", "buildings.gml"), "GML");
    fs::remove(seeds.path / "xml_map" / "buildings.xsd");
    require(writeCityGeoPackage(seeds.file("geopackage_bytes", "ours.gpkg"), threeHouses()).has_value(),
            "a GeoPackage is written");
    for (const char* name : {"gdal.gpkg", "ours.gpkg"}) shrink(seeds.path / "geopackage_bytes" / name);
    writeShapefile(seeds);
    writeTerrains(seeds);
    writeSurveys(seeds);
    writeCanopies(seeds);
    writeMap(seeds);
    writePictures(seeds);
}

}  // namespace noonmark::tests
