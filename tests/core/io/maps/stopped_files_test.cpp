// Readers that cannot be stopped in themselves find their file at its end after a stop request. How much of a
// file was read tells whether they did; time would not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <optional>

#include "core/base/gdal_calls.h"
#include "core/io/osm/osm_map.h"
#include "core/io/pictures/ground_raster_file.h"
#include "core/io/pieces/read_part.h"
#include "core/io/read_city.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

// Bytes that this process has read so far; nothing where the system does not say.
std::optional<std::uint64_t> bytesRead() {
    std::ifstream counts("/proc/self/io");
    std::string name;
    std::uint64_t bytes = 0;
    if (counts >> name >> bytes && name == "rchar:") return bytes;
    return std::nullopt;
}

constexpr std::size_t largeBytes = 30'000'000;

std::string repeated(std::string text, const std::string& part, const std::string& end) {
    while (text.size() < largeBytes) text += part;
    return text + end;
}

class StoppedFile : public testing::Test {
protected:
    void SetUp() override {
        if (!bytesRead()) GTEST_SKIP() << "the system does not count what is read";
        source_.request_stop();
    }

    // Expects that a city in this file is given up after a small part of it.
    void expectGivenUp(const std::string& name, const std::string& content) {
        const auto file = folder_.file(name, content);
        const std::uint64_t before = *bytesRead();
        const auto city = readCity({file}, {.crs = "EPSG:4326"}, quiet_, source_.get_token());
        ASSERT_FALSE(city);
        EXPECT_TRUE(isCancelled(city.error())) << city.error().text();
        EXPECT_LT(*bytesRead() - before, largeBytes / 10) << name;
    }

    std::stop_source source_;
    tests::TemporaryFolder folder_;
    NoProgress quiet_;
};

constexpr const char* squareFeature =
    R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"Polygon","coordinates":)"
    R"([[[-73.98,40.75],[-73.979,40.75],[-73.979,40.751],[-73.98,40.75]]]}},)";

TEST_F(StoppedFile, OfGeoJsonIsGivenUp) {
    expectGivenUp("city.geojson",
                  repeated(R"({"type":"FeatureCollection","features":[)", squareFeature, "]}"));
}

TEST_F(StoppedFile, OfLinesOfGeoJsonIsGivenUp) {
    expectGivenUp(
        "city.geojsonl",
        repeated("", std::string(squareFeature).substr(0, std::strlen(squareFeature) - 1) + "\n", ""));
}

TEST_F(StoppedFile, OfGmlIsGivenUp) {
    expectGivenUp(
        "city.gml",
        repeated("<ogr:FeatureCollection xmlns:ogr='http://ogr.maptools.org/' "
                 "xmlns:gml='http://www.opengis.net/gml'>",
                 "<gml:featureMember><ogr:city><ogr:height>12</ogr:height></ogr:city></gml:featureMember>",
                 "</ogr:FeatureCollection>"));
}

TEST_F(StoppedFile, OfElevationsInTextIsGivenUp) {
    expectGivenUp("dem.xyz", repeated("", "-73.98 40.75 12\n", ""));
}

TEST_F(StoppedFile, OfCityJsonIsGivenUp) {
    expectGivenUp("city.json", repeated(R"({"type":"CityJSON","version":"2.0","CityObjects":{},"vertices":[)",
                                        "[1,2,3],", "[1,2,3]]}"));
    expectGivenUp("late.json", repeated(R"({"vertices":[)", "[1,2,3],", R"([1,2,3]],"type":"CityJSON"})"));
}

TEST_F(StoppedFile, OfOpenStreetMapIsGivenUp) {
    expectGivenUp("city.osm",
                  repeated("<osm version='0.6'>", "<node id='1' lat='40.75' lon='-73.98'/>", "</osm>"));
}

}  // namespace
}  // namespace noonmark
