#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/elements/read_glazing.h"
#include "core/io/read_city.h"
#include "tests/core/io/citygml_fixtures.h"

namespace noonmark {
namespace {

using tests::bonn;
using tests::cityGml;
using tests::gmlBoxSolid;
using tests::gmlBuilding;
using tests::gmlMultiSurface;
using tests::gmlPolygon;
using tests::TemporaryFolder;

// A wall with this opening in it.
std::string wallWith(const std::string& opening) {
    return "<bldg:boundedBy><bldg:WallSurface><bldg:opening>" + opening +
           "</bldg:opening></bldg:WallSurface></bldg:boundedBy>";
}

std::string openingOf(const std::string& kind, double x, const std::string& id = {}) {
    const auto at = [x](double dx, double z) { return bonn + glm::dvec3(x + dx, 0, z); };
    return fmt::format("<bldg:{0}{1}><bldg:lod3MultiSurface>{2}</bldg:lod3MultiSurface></bldg:{0}>", kind,
                       id.empty() ? "" : " gml:id=\"" + id + "\"",
                       gmlMultiSurface({gmlPolygon({at(0, 1), at(1, 1), at(1, 3), at(0, 3)})}));
}

TEST(CityGmlGlazing, WindowsAndDoorsOfWallsAreRead) {
    const TemporaryFolder folder;
    NoProgress quiet;
    const std::string house =
        gmlBuilding("house", gmlBoxSolid({0, 0, 0}, {10, 8, 6}) + wallWith(openingOf("Window", 1, "w7")) +
                                 wallWith(openingOf("Window", 4)) + wallWith(openingOf("Door", 7)));
    const auto file = folder.file("city.gml", cityGml(house));
    const auto city = readCity({file}, {}, quiet, {});
    ASSERT_TRUE(city) << city.error().text();
    EXPECT_NEAR(topM(*city->city.buildings.at(0)), 6, 1e-3) << "windows alone are no house";
    const auto read = readGlazing(file, {}, city->city, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    std::vector<std::string> ids;
    for (const GlazingShape& window : read->windows) ids.push_back(window.id);
    EXPECT_THAT(ids, testing::ElementsAre("w7", "house window 2", "house door 1"));
    const GlazingShape& first = read->windows.front();
    ASSERT_EQ(first.corners.size(), 4U);
    EXPECT_NEAR(first.corners[2].z - first.corners[0].z, 2, 1e-6);
    EXPECT_NEAR(first.corners[1].x - first.corners[0].x, 1, 0.01);
}

TEST(CityGmlGlazing, AFileWithoutWindowsSaysSo) {
    const TemporaryFolder folder;
    NoProgress quiet;
    const auto file = folder.file("city.gml", cityGml(gmlBuilding("a", gmlBoxSolid({0, 0, 0}, {9, 9, 9}))));
    const auto read = readGlazing(file, {}, City{}, quiet, {});
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().what, testing::HasSubstr("marked as a window or a door"));
}

}  // namespace
}  // namespace noonmark
