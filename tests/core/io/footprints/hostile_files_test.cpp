// Untrusted files that try to reach the network, other files, or the folder they lie in. Each is read in
// every way that this program reads files; the result must be an error or harmless, and nothing may be
// written.
#include <fmt/format.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <chrono>
#include <fstream>
#include <map>
#include <sstream>

#include "core/base/gdal_calls.h"
#include "core/io/footprints/read_parcels.h"
#include "core/io/pieces/read_part.h"
#include "core/io/read_city.h"
#include "core/io/read_region.h"
#include "tests/core/io/local_listener.h"
#include "tests/core/io/planted_journal.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

namespace fs = std::filesystem;

std::string bytesIn(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
}

// The files in a folder with their content; for pipes without content.
std::map<std::string, std::string> contentOf(const fs::path& folder) {
    std::map<std::string, std::string> content;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        content[entry.path().string()] = entry.is_regular_file() ? bytesIn(entry.path()) : "";
    return content;
}

// Makes an SQLite file from statements; an empty one if they are wrong.
void runSql(const fs::path& file, const std::string& statements) {
    sqlite3* database = nullptr;
    sqlite3_open(file.c_str(), &database);
    char* error = nullptr;
    EXPECT_EQ(sqlite3_exec(database, statements.c_str(), nullptr, nullptr, &error), SQLITE_OK)
        << (error != nullptr ? error : "");
    sqlite3_free(error);
    sqlite3_close(database);
}

class HostileFile : public testing::Test {
protected:
    HostileFile() {
        EXPECT_TRUE(listener.listening());
        fs::create_directory(folder.path("canary"));
        runSql(folder.path("canary/database.sqlite"), "CREATE TABLE t (x); INSERT INTO t VALUES (1);");
        (void)folder.file("canary/raw.bin", std::string(400, 'c'));
        (void)folder.file("canary/names.csv", "a,b\n1,2\n");
    }

    [[nodiscard]] std::string canary(const std::string& name) const {
        return folder.path("canary/" + name).string();
    }

    /// Reads the file in every way and returns the errors, one per line; "read" for a way that succeeded.
    static std::string readEveryWay(const fs::path& file) {
        NoProgress quiet;
        const ReadSettings settings{.crs = "EPSG:4326"};
        const Frame frame(LonLat{-73.98, 40.75}, 0);
        std::string said;
        const auto note = [&](const auto& result) {
            said += (result ? std::string("read") : result.error().text()) + '\n';
        };
        note(readCity({file}, settings, quiet, {}));
        note(readFootprints(file, settings, quiet, {}));
        note(readTerrain(file, settings, quiet, {}));
        note(readRegion(file.string(), frame));
        note(readParcels(file, {}, frame, {}));
        return said;
    }

    /// Expects that no network request was made and nothing written; returns what readEveryWay() does.
    std::string expectNothingHappens(const fs::path& file) const {
        const auto before = contentOf(folder.path(""));
        const auto start = std::chrono::steady_clock::now();
        const std::string said = readEveryWay(file);
        const auto took = std::chrono::steady_clock::now() - start;
        EXPECT_EQ(listener.connections(), 0) << said;
        const auto after = contentOf(folder.path(""));
        for (const auto& [name, content] : after)
            EXPECT_TRUE(before.contains(name)) << name << " was written";
        for (const auto& [name, content] : before)
            EXPECT_TRUE(after.contains(name) && after.at(name) == content) << name << " was changed";
        EXPECT_LT(took, std::chrono::seconds(20));
        return said;
    }

    /// Expects in addition that no way succeeded.
    void expectRefused(const fs::path& file) const {
        EXPECT_EQ(expectNothingHappens(file).find("read\n"), std::string::npos) << file;
    }

    const tests::LocalListener listener;
    const tests::TemporaryFolder folder;
};

TEST_F(HostileFile, AVirtualVectorDatasetFetchesNothing) {
    for (const char* name : {"city.geojson", "city.gpkg", "city.shp", "city.vrt", "city"})
        expectRefused(
            folder.file(name, fmt::format("<OGRVRTDataSource><OGRVRTLayer name='a'><SrcDataSource>{}/"
                                          "a.geojson</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>",
                                          listener.address())));
}

TEST_F(HostileFile, AVirtualVectorDatasetRunsNoSql) {
    expectRefused(
        folder.file("city.geojson",
                    fmt::format("<OGRVRTDataSource><OGRVRTLayer name='a'><SrcDataSource>{}</SrcDataSource>"
                                "<SrcSQL>VACUUM INTO '{}'</SrcSQL></OGRVRTLayer></OGRVRTDataSource>",
                                canary("database.sqlite"), canary("written.sqlite"))));
}

TEST_F(HostileFile, AVirtualVectorDatasetOpensNoOtherFile) {
    const std::string said = expectNothingHappens(folder.file(
        "city.geojson",
        fmt::format("<OGRVRTDataSource><OGRVRTLayer name='names'><SrcDataSource>{}</SrcDataSource>"
                    "</OGRVRTLayer></OGRVRTDataSource>",
                    canary("names.csv"))));
    EXPECT_NE(said.find("virtual dataset"), std::string::npos) << said;
    EXPECT_EQ(said.find("names.csv"), std::string::npos) << said;
}

std::string virtualRaster(const std::string& source) {
    return fmt::format(
        "<VRTDataset rasterXSize='10' rasterYSize='10'><SRS>EPSG:32618</SRS>"
        "<GeoTransform>583000, 1, 0, 4507000, 0, -1</GeoTransform>"
        "<VRTRasterBand dataType='Float32' band='1'>{}</VRTRasterBand></VRTDataset>",
        source);
}

TEST_F(HostileFile, AVirtualRasterFetchesNothing) {
    for (const char* name : {"dem.tif", "dem.vrt", "dem.asc"})
        for (const char* scheme : {"/vsicurl/", "/vsicurl_streaming/", ""})
            expectRefused(folder.file(
                name, virtualRaster(fmt::format(
                          "<SimpleSource><SourceFilename>{}{}/dem.tif</SourceFilename></SimpleSource>",
                          scheme, listener.address()))));
}

TEST_F(HostileFile, ARawVirtualRasterReadsNoFile) {
    for (const int relative : {0, 1})
        expectRefused(folder.file(
            "dem.tif", fmt::format("<VRTDataset rasterXSize='10' rasterYSize='10'><SRS>EPSG:32618</SRS>"
                                   "<GeoTransform>583000, 1, 0, 4507000, 0, -1</GeoTransform>"
                                   "<VRTRasterBand dataType='Float32' band='1' subClass='VRTRawRasterBand'>"
                                   "<SourceFilename "
                                   "relativeToVRT='{}'>{}</SourceFilename><ImageOffset>0</"
                                   "ImageOffset><PixelOffset>4</PixelOffset>"
                                   "<LineOffset>40</LineOffset></VRTRasterBand></VRTDataset>",
                                   relative, relative != 0 ? "canary/raw.bin" : canary("raw.bin"))));
}

TEST_F(HostileFile, WebServicesAreNotAsked) {
    const std::string at = listener.address();
    const std::vector<std::string> services{
        fmt::format("<GDAL_WMS><Service name='WMS'><ServerUrl>{}/wms?</ServerUrl><Layers>a</Layers></Service>"
                    "<DataWindow><UpperLeftX>-74</UpperLeftX><UpperLeftY>41</UpperLeftY><LowerRightX>-73</"
                    "LowerRightX>"
                    "<LowerRightY>40</LowerRightY><SizeX>100</SizeX><SizeY>100</SizeY></DataWindow>"
                    "<BandsCount>1</BandsCount><Cache/></GDAL_WMS>",
                    at),
        fmt::format("<WCS_GDAL><ServiceURL>{}/wcs?</ServiceURL><CoverageName>a</CoverageName></WCS_GDAL>",
                    at),
        fmt::format("<GDAL_WMTS><GetCapabilitiesUrl>{}/wmts</GetCapabilitiesUrl></GDAL_WMTS>", at),
        fmt::format("<OGRWFSDataSource><URL>{}/wfs</URL></OGRWFSDataSource>", at),
        fmt::format("<CSW>{}</CSW>", at),
    };
    for (const std::string& service : services)
        for (const char* name : {"dem.tif", "city.gml", "city.xml"})
            expectRefused(folder.file(name, service));
}

TEST_F(HostileFile, ANameIsNoConnection) {
    const fs::path home = fs::current_path();
    fs::current_path(folder.path(""));
    const std::string port = listener.port();
    for (const std::string& name :
         {"PG:host=127.0.0.1 connect_timeout=2 port=" + port, "MYSQL:x,host=127.0.0.1,port=" + port,
          std::string("GPKG:canary"), std::string("WMS:x")})
        expectRefused(folder.file(name, "hello"));
    fs::current_path(home);
    for (const std::string& name :
         {"PG:host=127.0.0.1 connect_timeout=2 port=" + port, "WMS:" + listener.address() + "/wms?",
          "/vsicurl/" + listener.address() + "/a.geojson", listener.address() + "/a.geojson",
          "WFS:" + listener.address(), "/vsizip//vsicurl/" + listener.address() + "/a.zip/a.shp",
          "/vsigzip/" + canary("raw.bin")})
        expectRefused(name);
}

TEST_F(HostileFile, AGeoPackageRunsNoSqlOfItsMaker) {
    const auto geoPackage = [&](const std::string& name, const std::string& more) {
        const fs::path file = folder.path(name);
        fs::remove(file);
        runSql(
            file,
            "PRAGMA application_id = 1196444487; PRAGMA user_version = 10300;"
            "CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT, srs_id INTEGER PRIMARY KEY, organization "
            "TEXT, "
            "organization_coordsys_id INTEGER, definition TEXT, description TEXT);"
            "INSERT INTO gpkg_spatial_ref_sys VALUES ('WGS 84', 4326, 'EPSG', 4326, 'EPSG:4326', '');"
            "CREATE TABLE gpkg_geometry_columns (table_name TEXT, column_name TEXT, geometry_type_name TEXT, "
            "srs_id INTEGER, z TINYINT, m TINYINT);"
            "INSERT INTO gpkg_geometry_columns VALUES ('city', 'geom', 'POLYGON', 4326, 0, 0);" +
                more);
        return file;
    };
    const std::string contents =
        "CREATE TABLE gpkg_contents (table_name TEXT PRIMARY KEY, data_type TEXT, identifier TEXT, "
        "description "
        "TEXT, last_change TEXT, min_x REAL, min_y REAL, max_x REAL, max_y REAL, srs_id INTEGER);"
        "INSERT INTO gpkg_contents VALUES ('city', 'features', 'city', '', '', 0, 0, 1, 1, 4326);";
    const std::string endless = "WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT ";
    expectRefused(geoPackage("view.gpkg",
                             contents + "CREATE VIEW city AS " + endless + "x AS fid, NULL AS geom FROM n;"));
    expectRefused(
        geoPackage("contents.gpkg", "CREATE VIEW gpkg_contents AS " + endless +
                                        "'c' || x AS table_name, 'features' AS data_type, 'c' || x AS "
                                        "identifier, '' AS description, '' AS last_change, 0 AS min_x, 0 AS "
                                        "min_y, 1 AS max_x, 1 AS max_y, 4326 AS srs_id FROM n;"));
    expectRefused(geoPackage(
        "load.gpkg", contents + "CREATE VIEW city AS SELECT 1 AS fid, gdal_get_pixel_value('/vsicurl/" +
                         listener.address() + "/a.tif', 1, 'pixel', 0, 0) AS geom;"));
    EXPECT_NE(
        expectNothingHappens(
            geoPackage("computed.gpkg", contents + "CREATE TABLE city (fid INTEGER PRIMARY KEY, geom BLOB, "
                                                   "height TEXT AS (hex(zeroblob(400000000))));"
                                                   "INSERT INTO city (fid) VALUES (1);"))
            .find("is computed by SQL"),
        std::string::npos);
    expectRefused(geoPackage(
        "layers.gpkg",
        contents +
            "WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n WHERE x < 1000) INSERT INTO "
            "gpkg_contents SELECT 'c' || x, 'features', 'c' || x, '', '', 0, 0, 1, 1, 4326 FROM n;"));
    (void)expectNothingHappens(geoPackage(
        "trigger.gpkg", contents +
                            "CREATE TABLE city (fid INTEGER PRIMARY KEY, geom BLOB);"
                            "INSERT INTO city VALUES (1, NULL);"
                            "CREATE TRIGGER t AFTER UPDATE ON gpkg_contents BEGIN DELETE FROM city; END;"));
}

// A GeoPackage whose layer has one row, and `more`.
std::string smallGeoPackage(const std::string& columns, const std::string& more) {
    return "PRAGMA application_id = 1196444487; PRAGMA user_version = 10300;"
           "CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT, srs_id INTEGER PRIMARY KEY, organization TEXT, "
           "organization_coordsys_id INTEGER, definition TEXT, description TEXT);"
           "INSERT INTO gpkg_spatial_ref_sys VALUES ('WGS 84', 4326, 'EPSG', 4326, 'EPSG:4326', '');"
           "CREATE TABLE gpkg_geometry_columns (table_name TEXT, column_name TEXT, geometry_type_name TEXT, "
           "srs_id INTEGER, z TINYINT, m TINYINT);"
           "INSERT INTO gpkg_geometry_columns VALUES ('city', 'geom', 'POLYGON', 4326, 0, 0);"
           "CREATE TABLE gpkg_contents (table_name TEXT PRIMARY KEY, data_type TEXT, identifier TEXT, "
           "description "
           "TEXT, last_change TEXT, min_x REAL, min_y REAL, max_x REAL, max_y REAL, srs_id INTEGER);"
           "INSERT INTO gpkg_contents VALUES ('city', 'features', 'city', '', '', 0, 0, 1, 1, 4326);"
           "CREATE TABLE city (fid INTEGER PRIMARY KEY, geom BLOB" +
           columns + ");INSERT INTO city (fid) VALUES (1);" + more;
}

struct HostileGeoPackage : HostileFile {
    [[nodiscard]] fs::path make(const std::string& columns, const std::string& more = {}) const {
        const fs::path file = folder.path("city.gpkg");
        fs::remove(file);
        runSql(file, smallGeoPackage(columns, more));
        return file;
    }
    void expectRefusedFor(const fs::path& file, const std::string& why) const {
        const std::string said = expectNothingHappens(file);
        EXPECT_NE(said.find(why), std::string::npos) << said;
        EXPECT_EQ(said.find("read\n"), std::string::npos) << said;
    }
};

TEST_F(HostileGeoPackage, ComputesNoColumn) {
    for (const char* kind : {"VIRTUAL", "STORED"})
        expectRefusedFor(make(fmt::format(", big AS (zeroblob(9000000)) {}", kind)), "is computed by SQL");
    expectRefusedFor(make({}, "CREATE TABLE other (a, b AS (hex(zeroblob(400000000))));"),
                     "is computed by SQL");
}

TEST_F(HostileGeoPackage, HasNoViewForItsIndex) {
    expectRefusedFor(
        make({},
             "CREATE VIEW rtree_city_geom AS WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x "
             "+ 1 FROM n) SELECT x AS id, 0 AS minx, 1 AS maxx, 0 AS miny, 1 AS maxy FROM n;"),
        "a view or a virtual table");
    const std::string said = expectNothingHappens(
        make({}, "CREATE VIRTUAL TABLE rtree_city_geom USING rtree(id, minx, maxx, miny, maxy);"));
    EXPECT_EQ(said.find("virtual table"), std::string::npos) << said;
}

TEST_F(HostileGeoPackage, HasNoHugeTiles) {
    for (const char* size : {"65536, 256", "256, 5000", "0, 0", "NULL, 256", "'x', 256"})
        expectRefusedFor(
            make({}, fmt::format("CREATE TABLE gpkg_tile_matrix (table_name TEXT, zoom_level INTEGER, "
                                 "tile_width INTEGER, tile_height INTEGER);"
                                 "INSERT INTO gpkg_tile_matrix VALUES ('dem', 0, {});",
                                 size)),
            "The tiles of a layer are larger");
}

TEST_F(HostileGeoPackage, WithAJournalReachesNoOtherFile) {
    const fs::path victim = folder.file("thesis.txt", "years of work");
    const fs::path file = make({});
    tests::plantJournal(file, victim);
    expectRefusedFor(file, "names another file");
    tests::plantJournal(file);
    expectRefusedFor(file, "Another program was stopped while it wrote");
    fs::remove(file.string() + "-journal");
    fs::create_symlink(victim, file.string() + "-wal");
    expectRefusedFor(file, "is a link");
}

constexpr const char* gml =
    "<ogr:FeatureCollection xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' "
    "xsi:schemaLocation='http://ogr.maptools.org/ {0}/city.xsd' xmlns:ogr='http://ogr.maptools.org/' "
    "xmlns:gml='http://www.opengis.net/gml' xmlns:xlink='http://www.w3.org/1999/xlink'>"
    "<gml:featureMember><ogr:city fid='1'><ogr:geometryProperty><gml:Polygon srsName='EPSG:4326'>"
    "<gml:outerBoundaryIs><gml:LinearRing><gml:coordinates>-73.98,40.75 -73.979,40.75 -73.979,40.751 "
    "-73.98,40.75"
    "</gml:coordinates></gml:LinearRing></gml:outerBoundaryIs></gml:Polygon></ogr:geometryProperty>"
    "<ogr:part xlink:href='{0}/part.gml#p1'/><ogr:height>12</ogr:height></ogr:city></gml:featureMember>"
    "</ogr:FeatureCollection>";

TEST_F(HostileFile, GmlFetchesNoSchemaAndLeavesNothingBeside) {
    const std::string said =
        expectNothingHappens(folder.file("city.gml", fmt::format(gml, listener.address())));
    EXPECT_EQ(said.substr(0, 5), "read\n") << said;
    std::string service = fmt::format(gml, listener.address());
    const std::string schema = listener.address() + "/city.xsd";
    service.replace(service.find(schema), schema.size(),
                    listener.address() +
                        "/wfs?SERVICE=WFS&amp;VERSION=1.1.0&amp;REQUEST=DescribeFeatureType&amp;"
                        "TYPENAME=city");
    (void)expectNothingHappens(folder.file("wfs.gml", service));
}

TEST_F(HostileFile, GeoJsonFetchesNoReferenceSystem) {
    for (const char* link : {"link", "url"})
        (void)expectNothingHappens(folder.file(
            "city.geojson",
            fmt::format(
                R"({{"type":"FeatureCollection","crs":{{"type":"{0}","properties":{{"href":"{1}/crs","url":"{1}/crs",)"
                R"("type":"ogcwkt"}}}},"links":[{{"rel":"next","href":"{1}/next"}}],"features":[{{"type":"Feature",)"
                R"("properties":{{}},"geometry":{{"type":"Polygon","coordinates":[[[-73.98,40.75],[-73.979,40.75],)"
                R"([-73.979,40.751],[-73.98,40.75]]]}}}}]}})",
                link, listener.address())));
}

TEST_F(HostileFile, KmlFollowsNoLink) {
    (void)expectNothingHappens(folder.file(
        "city.kml",
        fmt::format("<kml xmlns='http://www.opengis.net/kml/2.2'><Document><NetworkLink><Link><href>{}/a.kml"
                    "</href></Link></NetworkLink></Document></kml>",
                    listener.address())));
}

fs::path elevations(const tests::TemporaryFolder& folder, const std::string& overview) {
    const GdalCalls calls;
    const fs::path file = folder.path("dem.tif");
    fs::remove(file);
    GDALDatasetUniquePtr dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), 600, 600, 1, GDT_Float32, nullptr));
    double place[] = {583000, 1, 0, 4507000, 0, -1};
    dataset->SetGeoTransform(place);
    OGRSpatialReference system;
    system.importFromEPSG(32618);
    dataset->SetSpatialRef(&system);
    dataset->GetRasterBand(1)->Fill(12);
    if (!overview.empty()) dataset->SetMetadataItem("OVERVIEW_FILE", overview.c_str(), "OVERVIEWS");
    return file;
}

TEST_F(HostileFile, OverviewsAreTakenFromTheRasterItselfOnly) {
    for (const std::string& overview :
         {"/vsicurl/" + listener.address() + "/dem.ovr", "WMS:" + listener.address() + "/wms?",
          "/vsizip//vsicurl/" + listener.address() + "/a.zip/dem.tif"}) {
        const std::string said = expectNothingHappens(elevations(folder, overview));
        EXPECT_EQ(said.substr(0, 5), "read\n") << said;
    }
    const fs::path file = elevations(folder, "");
    (void)folder.file("dem.tif.ovr",
                      virtualRaster("<SimpleSource><SourceFilename>/vsicurl/" + listener.address() +
                                    "/a.tif</SourceFilename></SimpleSource>"));
    (void)expectNothingHappens(file);
    fs::remove(folder.path("dem.tif.ovr"));
    (void)folder.file("dem.tif.aux.xml",
                      "<PAMDataset><Metadata domain='OVERVIEWS'><MDI key='OVERVIEW_FILE'>/vsicurl/" +
                          listener.address() + "/a.tif</MDI></Metadata></PAMDataset>");
    EXPECT_EQ(expectNothingHappens(file).substr(0, 5), "read\n");
}

TEST_F(HostileFile, TerrainLeavesNothingBeside) {
    std::string rows;
    for (int i = 0; i < 40 * 40; ++i) rows += std::to_string(i % 17) + (i % 40 == 39 ? "\n" : " ");
    const std::string head =
        "ncols 40\nnrows 40\nxllcorner -73.99\nyllcorner 40.74\ncellsize 0.0003\nNODATA_value -9999\n";
    const std::string said = expectNothingHappens(folder.file("dem.asc", head + rows));
    EXPECT_EQ(said.substr(0, 5), "read\n") << said;
}

TEST_F(HostileFile, PipesAndDevicesAreRefusedAtOnce) {
    for (const char* name : {"pipe.geojson", "pipe.tif", "pipe.obj"}) {
        ASSERT_EQ(::mkfifo(folder.path(name).c_str(), 0600), 0);
        expectRefused(folder.path(name));
    }
    expectRefused("/dev/zero");
    (void)folder.file("city.shp", std::string("\0\0\x27\x0a", 4) + std::string(96, '\0'));
    ASSERT_EQ(::mkfifo(folder.path("city.dbf").c_str(), 0600), 0);
    expectRefused(folder.path("city.shp"));
}

}  // namespace
}  // namespace noonmark
