#include "core/io/footprints/footprint_scan.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/base/progress.h"
#include "core/io/read_city.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using tests::TemporaryFolder;

std::string houseAt(double west) {
    return fmt::format(R"("geometry":{{"type":"Polygon","coordinates":
        [[[{0},50.0001],[{1},50.0001],[{1},50.0003],[{0},50.0003],[{0},50.0001]]]}})",
                       west, west + 0.0002);
}

// Three houses: heights in a field that no list names, storeys, and two texts.
std::filesystem::path writeHouses(const TemporaryFolder& folder) {
    const auto file = folder.path("houses.geojson");
    std::ofstream out(file);
    out << R"({"type":"FeatureCollection","features":[)";
    const char* const rows[] = {R"("QX7":4.5,"storeys":2,"title":"Mill","note":"a")",
                                R"("QX7":12,"storeys":4,"title":"Barn","note":"a")",
                                R"("QX7":30.25,"storeys":9,"title":null,"note":"a")"};
    double west = 10;
    for (const char* row : rows) {
        out << (row == rows[0] ? "" : ",")
            << fmt::format(R"({{"type":"Feature","properties":{{{}}},{}}})", row, houseAt(west));
        west += 0.0005;
    }
    out << "]}";
    return file;
}

const ListedField& fieldOf(const ListedLayer& layer, const std::string& name) {
    const auto found = std::ranges::find(layer.fields, name, &ListedField::name);
    EXPECT_NE(found, layer.fields.end()) << name;
    return *found;
}

TEST(ListFields, ShowsWhatEachFieldHolds) {
    const TemporaryFolder folder;
    const auto layers = listLayers(writeHouses(folder), {});
    ASSERT_TRUE(layers) << layers.error().what;
    ASSERT_EQ(layers->size(), 1U);
    const ListedLayer& layer = layers->front();
    EXPECT_TRUE(layer.isRead);
    EXPECT_EQ(layer.features, 3U);
    EXPECT_EQ(describeValues(fieldOf(layer, "QX7"), layer.sampled),
              "4.5, 12, 30.25 (4.5 to 30.25 in 3 of 3 features)");
    EXPECT_EQ(describeValues(fieldOf(layer, "title"), layer.sampled), "Mill, Barn (2 of 3 features)");
    EXPECT_EQ(describeValues(fieldOf(layer, "note"), layer.sampled), "a (3 of 3 features)");
    EXPECT_EQ(nameOfRole(fieldOf(layer, "storeys").role), "storeys");
    EXPECT_EQ(nameOfRole(fieldOf(layer, "QX7").role), "");
}

TEST(ListFields, ShowsRealNumbersWithoutTheDecimalsOfTheirColumn) {
    const auto file = tests::sharedData("goteborg/buildings.shp");
    if (!file) GTEST_SKIP() << "the shared data is not there";
    const auto layers = listLayers(*file, {});
    ASSERT_TRUE(layers) << layers.error().what;
    EXPECT_EQ(describeValues(fieldOf(layers->front(), "KVALITET"), layers->front().sampled),
              "200 (200 to 200 in 137 of 137 features)");
}

TEST(ListFields, HasNothingToChooseInAMesh) {
    const TemporaryFolder folder;
    std::ofstream(folder.path("cube.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const auto layers = listLayers(folder.path("cube.obj"), {});
    ASSERT_TRUE(layers) << layers.error().what;
    EXPECT_TRUE(layers->empty());
    EXPECT_FALSE(listLayers(folder.path("missing.gpkg"), {}));
}

TEST(ListFields, ChosenFieldsGiveHeightsAndNames) {
    const TemporaryFolder folder;
    ReadSettings settings;
    settings.heightField = "QX7";
    settings.nameField = "note";
    NoProgress quiet;
    const auto read = readCity({writeHouses(folder)}, settings, quiet, {});
    ASSERT_TRUE(read) << read.error().what;
    for (const auto& building : read->city.buildings) EXPECT_EQ(building->name, "a");
    EXPECT_EQ(topM(*read->city.buildings.front()), 4.5F);
    settings.nameField = "names";
    EXPECT_FALSE(readCity({writeHouses(folder)}, settings, quiet, {})) << "there is no such field";
}

}  // namespace
}  // namespace noonmark
