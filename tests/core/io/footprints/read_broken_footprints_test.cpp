#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>

#include "core/io/formats/format.h"
#include "core/io/osm/read_osm_buildings.h"
#include "tests/core/io/osm_text.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

// Whatever a file holds, reading it gives a city or an error with a message.
void readAndJudge(const std::filesystem::path& file) {
    NoProgress quiet;
    const auto result = findByEnding(file, FileKind::footprints)->reader.read(file, {}, quiet, {}, nullptr);
    if (!result) {
        EXPECT_FALSE(result.error().what.empty());
        return;
    }
    for (const auto& building : result->buildings) {
        ASSERT_FALSE(building->parts.empty());
        for (const Part& part : building->parts) {
            ASSERT_LT(part.bottomM, part.topM);
            ASSERT_GE(part.footprint.outer.size(), 3U);
        }
    }
}

std::string osmText() {
    tests::OsmText osm;
    osm.way(tests::sizedRectangle(0, 0, 40, 20), {{"building", "yes"}, {"height", "90"}});
    osm.way(tests::sizedRectangle(0, 0, 20, 20), {{"building:part", "yes"}, {"height", "20"}});
    osm.relation(tests::sizedRectangle(60, 0, 40, 40), {tests::sizedRectangle(70, 10, 10, 10)},
                 {{"building", "yes"}});
    return osm.xml();
}

constexpr std::string_view oneHouse =
    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"height":"12 m","num_floors":3},)"
    R"("geometry":{"type":"Polygon","coordinates":[[[-73.98,40.75],[-73.9799,40.75],[-73.9799,40.7501],[-73.98,40.75]]]}}]})";

TEST(ReadBrokenFootprints, CutShortAtEveryLength) {
    const tests::TemporaryFolder folder;
    for (std::size_t length = 0; length <= oneHouse.size(); ++length)
        readAndJudge(folder.file("cut.geojson", oneHouse.substr(0, length)));
    const std::string osm = osmText();
    for (std::size_t length = 0; length <= osm.size(); length += 41)
        readAndJudge(folder.file("cut.osm", osm.substr(0, length)));
}

TEST(ReadBrokenFootprints, TrueIsNoHeight) {
    const tests::TemporaryFolder folder;
    constexpr std::string_view height = R"("12 m")";
    const std::size_t at = oneHouse.find(height);
    const std::string text =
        fmt::format("{}true{}", oneHouse.substr(0, at), oneHouse.substr(at + height.size()));
    NoProgress quiet;
    const auto piece = readFootprints(folder.file("true.geojson", text), {}, quiet, {});
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.at(0)->parts.at(0).heightSource, HeightSource::levels);
    const bool said = std::ranges::any_of(piece->warnings, [](const Warning& warning) {
        return warning.where.find("height = \"true\"") != std::string::npos;
    });
    EXPECT_TRUE(said);
}

TEST(ReadBrokenFootprints, WithBytesChanged) {
    const tests::TemporaryFolder folder;
    std::mt19937 random(20260321);
    for (int round = 0; round < 200; ++round) {
        std::string text = round % 2 == 0 ? std::string(oneHouse) : osmText();
        for (int i = 0; i < 3; ++i) text[random() % text.size()] = char(random() % 256);
        readAndJudge(folder.file(round % 2 == 0 ? "odd.geojson" : "odd.osm", text));
    }
}

TEST(ReadBrokenFootprints, APbfCutShortAtManyLengths) {
    const auto whole = tests::sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!whole) GTEST_SKIP() << "the shared Midtown extract is missing";
    const tests::TemporaryFolder folder;
    std::ifstream stream(*whole, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    const std::string content = bytes.str();
    std::mt19937 random(7);
    for (int round = 0; round < 40; ++round)
        readAndJudge(folder.file("cut.osm.pbf", content.substr(0, random() % (content.size() / 4))));
}

TEST(ReadBrokenFootprints, APbfThatBreaksOffIsAnError) {
    const auto whole = tests::sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!whole) GTEST_SKIP() << "the shared Midtown extract is missing";
    const tests::TemporaryFolder folder;
    std::ifstream stream(*whole, std::ios::binary);
    std::string content(1000000, '\0');
    stream.read(content.data(), std::streamsize(content.size()));
    NoProgress quiet;
    const auto result = readOsmFootprints(folder.file("cut.osm.pbf", content), {}, quiet, {});
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().text().find("cut.osm.pbf"), std::string::npos);
}

}  // namespace
}  // namespace noonmark
