#include "core/study/elements/element_models.h"

#include <gtest/gtest.h>

#include "core/io/read_city.h"
#include "core/study/elements/element_map.h"
#include "tests/core/io/cityjson_fixtures.h"

namespace noonmark {
namespace {

using namespace tests;

// A box of 12 x 12 x 9 m: the ground and the roof have semantics of their own, all walls share one.
Json markedBox() {
    CityJsonMaker maker;
    Json solid = maker.boxSolid({0, 0, 0}, {12, 12, 9});
    solid["semantics"] = {
        {"surfaces", {{{"type", "GroundSurface"}}, {{"type", "RoofSurface"}}, {{"type", "WallSurface"}}}},
        {"values", {{0, 1, 2, 2, 2, 2}}}};
    maker.addBuilding("house", solid);
    return maker.document();
}

struct MeasuredBox {
    ElementStudy study;
    ElementMap map;
};

MeasuredBox measure(const std::filesystem::path& file) {
    NoProgress quiet;
    const City city = readCity({file}, {}, quiet, {}).value().city;
    StudySettings settings;
    settings.region = makeRegionFromLocalBox(bounds(city));
    settings.period = {
        .start = std::chrono::year(2026) / 3 / 21, .days = 1, .window = SolarHours{}, .zone = "UTC"};
    ElementStudy study = runElementStudy(city, settings, {}, quiet, {}).value();
    study.provenance.inputs = {describeInputFile(file).value()};
    ElementMap map = makeElementMap(study);
    return {std::move(study), std::move(map)};
}

TEST(ElementCityJson, StatesTheHoursOfEachWall) {
    const TemporaryFolder folder;
    const auto file = folder.file("box.city.json", markedBox().dump());
    const auto [study, map] = measure(file);
    ASSERT_EQ(map.elements.size(), 48U) << "4 walls, 4 bays, 3 storeys";
    const auto copy = copyCityJsonOf(study, map);
    ASSERT_TRUE(copy);
    const Json semantics = Json::parse(*copy)["CityObjects"]["house"]["geometry"][0]["semantics"];
    // Each wall has an object of its own now; the ground and the roof, without points, stay as they were.
    std::map<std::string, double> byMean;
    for (std::size_t wall = 2; wall < 6; ++wall) {
        const Json& surface = semantics["surfaces"][semantics["values"][0][wall].get<std::size_t>()];
        EXPECT_EQ(surface["type"], "WallSurface");
        EXPECT_EQ(surface["sunlight_points"], 12);
        EXPECT_LE(surface["sunlight_hours_per_day_min"], surface["sunlight_hours_per_day_mean"]);
        byMean[std::to_string(wall)] = surface["sunlight_hours_per_day_mean"];
    }
    EXPECT_FALSE(semantics["surfaces"][0].contains("sunlight_points"));
    EXPECT_FALSE(semantics["surfaces"][1].contains("sunlight_points"));
    // Nothing stands around: on the equinox the south wall (the third face) has the sun all day, the north
    // wall none, the others half of it.
    EXPECT_NEAR(byMean["2"], map.possibleMin / 60, 0.3);
    EXPECT_NEAR(byMean["3"], 0, 0.3);
    EXPECT_NEAR(byMean["4"] + byMean["5"], map.possibleMin / 60, 0.3);
    NoProgress quiet;
    EXPECT_TRUE(readCity({folder.file("copy.city.json", *copy)}, {}, quiet, {})) << "it is CityJSON still";
}

TEST(ElementCityJson, IsNotWrittenForAChangedFile) {
    const TemporaryFolder folder;
    const auto file = folder.file("box.city.json", markedBox().dump());
    const auto [study, map] = measure(file);
    ASSERT_EQ(folder.file("box.city.json", markedBox().dump() + "\n"), file);
    EXPECT_FALSE(copyCityJsonOf(study, map));
}

TEST(ElementCityJson, RefusesWhatHasNoSurfaceWithPoints) {
    const TemporaryFolder folder;
    const auto [study, map] = measure(folder.file("box.city.json", markedBox().dump()));
    const auto of = [&](const std::string& text) {
        return addHoursToCityJson(folder.file("other.json", text), "", study.city, map, {});
    };
    Json unmarked = markedBox();
    unmarked["CityObjects"]["house"]["geometry"][0].erase("semantics");
    EXPECT_FALSE(of(unmarked.dump()));
    EXPECT_FALSE(of("{}"));
    EXPECT_FALSE(of("not json"));
    Json strange = markedBox();
    strange["CityObjects"]["house"]["geometry"][0]["semantics"]["values"] = {{9, -1, "x", nullptr, {1}, 2}};
    strange["vertices"][3] = {"x", 1e308};
    EXPECT_FALSE(of(strange.dump()));
}

}  // namespace
}  // namespace noonmark
