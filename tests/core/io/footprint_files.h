#pragma once

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "core/base/gdal_calls.h"
#include "core/io/formats/format.h"
#include "core/io/pieces/read_part.h"
#include "tests/core/io/osm_text.h"
#include "tests/core/io/temporary_folder.h"

// Files of footprints, and the fixture that reads them.
namespace noonmark::tests {

inline constexpr LonLat manhattan{-73.98, 40.75};

class ReadFootprints : public testing::Test {
protected:
    Result<FilePiece> tryRead(const std::filesystem::path& file) {
        NoProgress quiet;
        const Format* format = findByEnding(file, FileKind::footprints);
        const auto read = format == nullptr ? readFootprints : format->reader.read;
        return read(file, settings, quiet, {}, nullptr);
    }
    FilePiece read(const std::filesystem::path& file) {
        auto result = tryRead(file);
        EXPECT_TRUE(result) << result.error().text();
        return result ? *std::move(result) : FilePiece();
    }
    FilePiece readGeoJson(const std::string& features, const std::string& head = "") {
        return read(geoJson(features, head));
    }
    std::filesystem::path geoJson(const std::string& features, const std::string& head = "") {
        return folder.file("a.geojson",
                           R"({"type":"FeatureCollection",)" + head + R"("features":[)" + features + "]}");
    }
    std::string errorOf(const std::filesystem::path& file) {
        const auto result = tryRead(file);
        EXPECT_FALSE(result);
        return result ? "" : result.error().text();
    }

    TemporaryFolder folder;
    ReadSettings settings;
};

inline std::string ringText(const std::vector<LonLat>& places) {
    std::string text;
    for (const LonLat place : places) text += fmt::format("[{:.10f},{:.10f}],", place.lonDeg, place.latDeg);
    text += fmt::format("[{:.10f},{:.10f}]", places[0].lonDeg, places[0].latDeg);
    return "[" + text + "]";
}

// A rectangle in metres around a place, as GeoJSON.
inline std::string feature(const Ring& ring, const std::string& properties, LonLat around = manhattan) {
    std::vector<LonLat> places;
    for (const glm::vec2 point : ring) places.push_back(Frame(around).lonLatFromLocal(glm::dvec2(point)));
    return fmt::format(
        R"({{"type":"Feature","properties":{{{}}},"geometry":{{"type":"Polygon","coordinates":[{}]}}}})",
        properties, ringText(places));
}

inline std::vector<std::string> whats(const Warnings& warnings) {
    std::vector<std::string> texts;
    for (const Warning& warning : warnings) texts.push_back(warning.what);
    return texts;
}

// Writes one rectangle in the given system with a GDAL driver.
inline void writeRectangle(const std::filesystem::path& file, const char* driver, const char* crs,
                           const std::vector<std::pair<std::string, double>>& fields) {
    const GdalCalls calls;
    OGRSpatialReference wgs84, system;
    wgs84.SetWellKnownGeogCS("WGS84");
    const bool statesNone = *crs == '\0';
    system.SetFromUserInput(statesNone ? "WGS84" : crs);
    for (OGRSpatialReference* one : {&wgs84, &system})
        one->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> there(
        OGRCreateCoordinateTransformation(&wgs84, &system));
    OGRLinearRing line;
    for (const glm::vec2 point : sizedRectangle(-20, -10, 40, 20)) {
        const LonLat place = Frame(manhattan).lonLatFromLocal(glm::dvec2(point));
        double x = place.lonDeg;
        double y = place.latDeg;
        ASSERT_TRUE(there->Transform(1, &x, &y));
        line.addPoint(x, y);
    }
    line.closeRings();
    OGRPolygon polygon;
    polygon.addRing(&line);
    const GDALDatasetUniquePtr dataset(
        GetGDALDriverManager()->GetDriverByName(driver)->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    OGRLayer* layer = dataset->CreateLayer("houses", statesNone ? nullptr : &system, wkbPolygon, nullptr);
    for (const auto& [name, value] : fields) {
        OGRFieldDefn field(name.c_str(), OFTReal);
        layer->CreateField(&field);
    }
    OGRFeature made(layer->GetLayerDefn());
    for (int i = 0; i < int(fields.size()); ++i) made.SetField(i, fields[std::size_t(i)].second);
    made.SetGeometry(&polygon);
    ASSERT_EQ(layer->CreateFeature(&made), OGRERR_NONE);
}

}  // namespace noonmark::tests
