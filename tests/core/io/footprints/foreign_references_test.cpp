// Files whose coordinate reference system, schema or companion names another file. That file must stay
// closed, whoever reads: PROJ, GDAL's drivers or our own readers.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <fstream>

#include "core/base/gdal_calls.h"
#include "core/io/footprints/read_parcels.h"
#include "core/io/pictures/ground_raster_file.h"
#include "core/io/pieces/read_part.h"
#include "core/io/places/read_places.h"
#include "core/io/read_city.h"
#include "core/io/read_region.h"
#include "core/study/provenance/provenance.h"
#include "tests/core/io/open_watch.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

namespace fs = std::filesystem;

class ForeignReference : public testing::Test {
protected:
    ForeignReference()
        : canary(secret.file("canary", "<x> +proj=longlat +ellps=WGS84 <>").string()), watch(canary) {
        EXPECT_TRUE(watch.watching());
    }

    void expectClosed(const fs::path& file) const {
        NoProgress quiet;
        const Frame frame(LonLat{-73.98, 40.75}, 0);
        (void)watch.wasOpened();
        const auto city = readCity({file}, {}, quiet, {});
        (void)readFootprints(file, {}, quiet, {});
        (void)readTerrain(file, {}, quiet, {});
        (void)readRegion(file.string(), frame);
        (void)readParcels(file, {}, frame, {});
        (void)readGroundRaster(file, frame, {{-100, -100}, {100, 100}}, {}, quiet, {});
        EXPECT_FALSE(watch.wasOpened()) << (city ? "read" : city.error().text());
    }

    [[nodiscard]] std::vector<std::string> systems() const {
        return {"+init=" + canary + ":x", "+proj=longlat +ellps=bessel +nadgrids=" + canary, canary};
    }

    const tests::TemporaryFolder secret, folder;
    const std::string canary;
    const tests::OpenWatch watch;
};

TEST_F(ForeignReference, OfGeoJsonStaysClosed) {
    for (const std::string& system : systems())
        expectClosed(folder.file(
            "city.geojson",
            fmt::format(
                R"({{"type":"FeatureCollection","crs":{{"type":"name","properties":{{"name":"{}"}}}},"features":)"
                R"([{{"type":"Feature","properties":{{"height":9}},"geometry":{{"type":"Polygon","coordinates":)"
                R"([[[-73.98,40.75],[-73.979,40.75],[-73.979,40.751],[-73.98,40.75]]]}}}}]}})",
                system)));
}

TEST_F(ForeignReference, OfCityJsonStaysClosed) {
    for (const std::string& system : systems())
        expectClosed(folder.file(
            "city.json",
            fmt::format(
                R"({{"type":"CityJSON","version":"2.0","metadata":{{"referenceSystem":"{}"}},"transform":)"
                R"({{"scale":[1,1,1],"translate":[0,0,0]}},"vertices":[[0,0,0],[1,0,0],[1,1,0]],)"
                R"("CityObjects":{{"a":{{"type":"Building","geometry":[{{"type":"MultiSurface","lod":"1",)"
                R"("boundaries":[[[0,1,2]]]}}]}}}}}})",
                system)));
}

std::string gmlIn(const std::string& system, const std::string& schema) {
    return fmt::format(
        "<ogr:FeatureCollection xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' "
        "xsi:schemaLocation='http://"
        "ogr.maptools.org/ {1}' xmlns:ogr='http://ogr.maptools.org/' xmlns:gml='http://www.opengis.net/gml'>"
        "<gml:boundedBy><gml:Envelope srsName='{0}'><gml:lowerCorner>-74 "
        "40</gml:lowerCorner><gml:upperCorner>-73 "
        "41</gml:upperCorner></gml:Envelope></gml:boundedBy><gml:featureMember><ogr:city fid='1'>"
        "<ogr:geometryProperty><gml:Polygon "
        "srsName='{0}'><gml:outerBoundaryIs><gml:LinearRing><gml:coordinates>"
        "-73.98,40.75 -73.979,40.75 -73.979,40.751 -73.98,40.75</gml:coordinates></gml:LinearRing>"
        "</gml:outerBoundaryIs></gml:Polygon></ogr:geometryProperty><ogr:height>12</ogr:height></ogr:city>"
        "</gml:featureMember></ogr:FeatureCollection>",
        system, schema);
}

TEST_F(ForeignReference, OfGmlStaysClosed) {
    for (const std::string& system : systems()) expectClosed(folder.file("city.gml", gmlIn(system, "x.xsd")));
    expectClosed(folder.file("city.gml", gmlIn("EPSG:4326", canary)));
}

TEST_F(ForeignReference, OfASchemaBesideGmlStaysClosed) {
    const fs::path file = folder.file("city.gml", gmlIn("EPSG:4326", "city.xsd"));
    (void)folder.file(
        "city.xsd",
        fmt::format("<xs:schema xmlns:xs='http://www.w3.org/2001/XMLSchema' "
                    "targetNamespace='http://ogr.maptools.org/'><xs:include schemaLocation='{0}'/>"
                    "<xs:import namespace='a' schemaLocation='{0}'/></xs:schema>",
                    canary));
    expectClosed(file);
    fs::remove(folder.path("city.xsd"));
    for (const std::string& system : systems()) {
        (void)folder.file(
            "city.gfs",
            fmt::format("<GMLFeatureClassList><GMLFeatureClass><Name>city</Name><ElementPath>city"
                        "</ElementPath><SRSName>{}</SRSName></GMLFeatureClass></GMLFeatureClassList>",
                        system));
        expectClosed(file);
    }
}

TEST_F(ForeignReference, OfAGeoPackageStaysClosed) {
    for (const std::string& system : systems()) {
        const fs::path file = folder.path("city.gpkg");
        fs::remove(file);
        {
            const GdalCalls calls;
            OGRSpatialReference degrees;
            degrees.SetWellKnownGeogCS("WGS84");
            const GDALDatasetUniquePtr made(GetGDALDriverManager()->GetDriverByName("GPKG")->Create(
                file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
            OGRLayer* layer = made->CreateLayer("city", &degrees, wkbPolygon);
            OGRFeature feature(layer->GetLayerDefn());
            OGRGeometry* square = nullptr;
            OGRGeometryFactory::createFromWkt(
                "POLYGON((-73.98 40.75,-73.979 40.75,-73.979 40.751,-73.98 40.75))", nullptr, &square);
            feature.SetGeometryDirectly(square);
            ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
        }
        sqlite3* database = nullptr;
        sqlite3_open(file.c_str(), &database);
        const std::string change = fmt::format(
            "UPDATE gpkg_spatial_ref_sys SET organization = 'x', organization_coordsys_id = 9, definition = "
            "'{}' "
            "WHERE srs_id = 4326",
            system);
        EXPECT_EQ(sqlite3_exec(database, change.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
        sqlite3_close(database);
        expectClosed(file);
    }
}

constexpr const char* gridded =
    R"(GEOGCS["x",DATUM["d",SPHEROID["s",6378137,298],EXTENSION["PROJ4_GRIDS","{}"]],PRIMEM["Greenwich",0],)"
    R"(UNIT["degree",0.0174532925199433]])";

TEST_F(ForeignReference, BesideARasterStaysClosed) {
    std::string rows;
    for (int i = 0; i < 400; ++i) rows += "1 ";
    const fs::path file = folder.file(
        "dem.asc", "ncols 20\nnrows 20\nxllcorner -73.99\nyllcorner 40.74\ncellsize 0.0003\n" + rows);
    (void)folder.file("dem.prj", fmt::format(fmt::runtime(gridded), canary));
    expectClosed(file);
    fs::remove(folder.path("dem.prj"));
    for (const std::string& system : systems()) {
        (void)folder.file("dem.asc.aux.xml", "<PAMDataset><SRS>" + system + "</SRS></PAMDataset>");
        expectClosed(file);
    }
}

TEST_F(ForeignReference, BesideAShapefileStaysClosed) {
    {
        const GdalCalls calls;
        const GDALDatasetUniquePtr made(
            GetGDALDriverManager()
                ->GetDriverByName("ESRI Shapefile")
                ->Create(folder.path("city.shp").c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        OGRLayer* layer = made->CreateLayer("city", nullptr, wkbPolygon);
        OGRFeature feature(layer->GetLayerDefn());
        OGRGeometry* square = nullptr;
        OGRGeometryFactory::createFromWkt("POLYGON((-73.98 40.75,-73.979 40.75,-73.979 40.751,-73.98 40.75))",
                                          nullptr, &square);
        feature.SetGeometryDirectly(square);
        ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    }
    std::vector<std::string> texts = systems();
    texts.push_back(fmt::format(fmt::runtime(gridded), canary));
    for (const char* ending : {"prj", "qpj"})
        for (const std::string& text : texts) {
            (void)folder.file(std::string("city.") + ending, text);
            expectClosed(folder.path("city.shp"));
        }
}

TEST_F(ForeignReference, ToAPipeIsRefusedAtOnce) {
    ASSERT_EQ(::mkfifo(folder.path("photograph.tif").c_str(), 0600), 0);
    const auto described = describeInputFile(folder.path("photograph.tif"));
    ASSERT_FALSE(described);
    EXPECT_EQ(described.error().what, "This is a pipe or a device, not a file");
    ASSERT_EQ(::mkfifo(folder.path("schema").c_str(), 0600), 0);
    NoProgress quiet;
    (void)readCity(
        {folder.file("city.gml", gmlIn(folder.path("schema").string(), folder.path("schema").string()))}, {},
        quiet, {});
}

}  // namespace
}  // namespace noonmark
