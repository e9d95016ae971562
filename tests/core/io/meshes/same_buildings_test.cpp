#include "core/io/pieces/read_part.h"

#include <gtest/gtest.h>

#include "core/io/read_city.h"
#include "tests/core/io/footprint_files.h"

namespace noonmark::tests {
namespace {

std::shared_ptr<const Building> prism(const std::string& id, const Ring& outline, float bottomM, float topM,
                                      HeightSource source = HeightSource::measured) {
    return std::make_shared<const Building>(
        Building{id, {}, {}, {{id, {outline, {}}, bottomM, topM, source}}});
}

TEST(SameBuildings, AnOutlineThatIsThereTwiceIsFound) {
    const auto same = findSameBuildings({prism("a", sizedRectangle(0, 0, 20, 10), 0, 10),
                                         prism("b", sizedRectangle(50, 0, 20, 10), 0, 10),
                                         prism("c", sizedRectangle(0.1F, 0.1F, 20, 10), 0, 10)});
    ASSERT_EQ(same.size(), 1U);
    EXPECT_EQ(same[0].kept, 0U);
    EXPECT_EQ(same[0].dropped, 2U);
    EXPECT_FALSE(same[0].byId);
}

TEST(SameBuildings, TheBetterKnownHeightIsKept) {
    const Ring outline = sizedRectangle(0, 0, 20, 10);
    const auto same = findSameBuildings({prism("a", outline, 0, 30, HeightSource::assumed),
                                         prism("b", outline, 0, 20, HeightSource::levels),
                                         prism("c", outline, 0, 12, HeightSource::measured)});
    ASSERT_EQ(same.size(), 2U);
    for (const SameBuilding& one : same) EXPECT_NE(one.dropped, 2U);
}

TEST(SameBuildings, TheSameIdNeedsNoEqualOutline) {
    const auto whole = prism("way 7", sizedRectangle(0, 0, 40, 10), 0, 10);
    const auto clipped = prism("way 7", sizedRectangle(0, 0, 18, 10), 0, 10);
    const auto elsewhere = prism("way 7", sizedRectangle(100, 0, 18, 10), 0, 10);
    ASSERT_EQ(findSameBuildings({whole, clipped, elsewhere}).size(), 1U);
    EXPECT_TRUE(findSameBuildings({whole, clipped}).at(0).byId);
}

TEST(SameBuildings, NeighboursAndStoreysAreNotTheSame) {
    const Ring outline = sizedRectangle(0, 0, 20, 10);
    EXPECT_TRUE(findSameBuildings({prism("podium", outline, 0, 10), prism("tower", outline, 10, 60),
                                   prism("wing", sizedRectangle(20, 0, 20, 10), 0, 10),
                                   prism("pavilion", sizedRectangle(2, 2, 10, 6), 0, 20)})
                    .empty());
}

TEST(SameBuildings, TwoExtractsOfATownGiveEachHouseOnce) {
    const TemporaryFolder folder;
    std::vector<std::filesystem::path> files;
    for (const int extract : {0, 1}) {
        OsmText osm;
        for (int i = 0; i < 6; ++i) {
            const bool isInside = extract == 0 ? i < 4 : i >= 2;
            osm.way(sizedRectangle(float(i) * 30, 0, 12, 12),
                    isInside ? Tags{{"building", "yes"}, {"height", "15"}} : Tags{{"landuse", "grass"}});
        }
        files.push_back(folder.file(extract == 0 ? "west.osm" : "east.osm", osm.xml()));
    }
    NoProgress quiet;
    const CityRead read = readCity(files, {}, quiet, {}).value();
    EXPECT_EQ(read.city.buildings.size(), 6U);
    const auto groups = groupWarnings(read.warnings);
    const auto said = std::ranges::find_if(
        groups, [](const WarningGroup& group) { return group.what.find("same id") != std::string::npos; });
    ASSERT_NE(said, groups.end());
    EXPECT_EQ(said->where.size(), 2U);
}

// Without height and with one: a demolition of the building that is shown leaves open ground.
TEST(SameBuildings, AFeatureThatIsThereTwiceCanBeDemolished) {
    const TemporaryFolder folder;
    const auto file = folder.file(
        "a.geojson", R"({"type":"FeatureCollection","features":[)" +
                         feature(sizedRectangle(0, 0, 20, 20), R"("id":"outline")") + "," +
                         feature(sizedRectangle(0, 0, 20, 20), R"("id":"part","height":31)") + "]}");
    NoProgress quiet;
    const CityRead read = readCity({file}, {}, quiet, {}).value();
    ASSERT_EQ(read.city.buildings.size(), 1U);
    EXPECT_FLOAT_EQ(topM(*read.city.buildings[0]), 31);
}

}  // namespace
}  // namespace noonmark::tests
