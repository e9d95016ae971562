#include "core/io/elements/model_glazing.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <glm/geometric.hpp>

#include "core/geo/crs.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

// In the Dutch grid; heights above Amsterdam's datum.
constexpr double east = 90000, north = 437000;

// A wall 10 m wide that faces south, with a window of 2 x 1.5 m 3 m above its foot, and a door. Vertices are
// millimetres from (90000, 437000, 0).
std::string wallText(const std::string& semantics, const std::string& type = "MultiSurface",
                     const std::string& boundaries = "[[[0,1,2,3],[4,7,6,5]],[[4,5,6,7]],[[8,9,10,11]]]",
                     const std::string& values = "[0,1,2]") {
    return R"({"type":"CityJSON","version":"2.0","metadata":{"referenceSystem":"https://www.opengis.net/def/crs/EPSG/0/7415"},
"transform":{"scale":[0.001,0.001,0.001],"translate":[90000,437000,0]},
"vertices":[[0,0,0],[10000,0,0],[10000,0,9000],[0,0,9000],[4000,0,3000],[6000,0,3000],[6000,0,4500],[4000,0,4500],
[1000,0,0],[2000,0,0],[2000,0,2000],[1000,0,2000]],
"CityObjects":{"house":{"type":"Building","geometry":[{"type":")" +
           type + R"(","lod":"3.2","boundaries":)" + boundaries + R"(,"semantics":{"values":)" + values +
           R"(,"surfaces":)" + semantics + "}}]}}}";
}
const std::string usual = R"([{"type":"WallSurface"},{"type":"Window","name":"kitchen"},{"type":"Door"}])";

class CityJsonGlazing : public testing::Test {
protected:
    Result<GlazingRead> read(const std::string& text, const GlazingFileSettings& settings = {}) {
        NoProgress quiet;
        return readGlazing(folder_.file("city.city.json", text), settings, city_, quiet, {});
    }
    City city_ = [] {
        City city;
        const std::array place{glm::dvec2(east, north)};
        city.frame = Frame(CrsToLonLat::of("EPSG:7415").value().lonLat(place)[0], 1);
        return city;
    }();
    tests::TemporaryFolder folder_;
};

TEST_F(CityJsonGlazing, SurfacesMarkedAsWindowOrDoorAreWindows) {
    const auto found = read(wallText(usual));
    ASSERT_TRUE(found) << found.error().text();
    ASSERT_EQ(found->windows.size(), 2U);
    const GlazingShape& window = found->windows[0];
    EXPECT_EQ(window.id, "kitchen");
    ASSERT_EQ(window.corners.size(), 4U);
    EXPECT_NEAR(window.corners[0].z, 2, 1e-6) << "3 m, and the frame begins at 1 m";
    EXPECT_NEAR(window.corners[2].z, 3.5, 1e-6);
    EXPECT_NEAR(glm::distance(window.corners[0], window.corners[1]), 2, 1e-3);
    EXPECT_NEAR(glm::length(glm::dvec2(window.corners[0])), 4, 1e-2);
    EXPECT_EQ(found->windows[1].id, "house door 1");
}

TEST_F(CityJsonGlazing, TheSameInASolidAndInASequence) {
    const auto solid =
        read(wallText(usual, "Solid", "[[[[0,1,2,3]],[[4,5,6,7]],[[8,9,10,11]]]]", "[[0,1,2]]"));
    ASSERT_TRUE(solid) << solid.error().text();
    EXPECT_EQ(solid->windows.size(), 2U);
    const auto lines = read(
        R"({"type":"CityJSON","version":"2.0","metadata":{"referenceSystem":"https://www.opengis.net/def/crs/EPSG/0/7415"},"transform":{"scale":[0.001,0.001,0.001],"translate":[90000,437000,0]},"CityObjects":{},"vertices":[]}
{"type":"CityJSONFeature","id":"h","vertices":[[0,0,0],[2000,0,0],[2000,0,2000]],"CityObjects":{"h":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"3","boundaries":[[[0,1,2]]],"semantics":{"values":[0],"surfaces":[{"type":"Window"}]}}]}}}
)");
    ASSERT_TRUE(lines) << lines.error().text();
    ASSERT_EQ(lines->windows.size(), 1U);
    EXPECT_EQ(lines->windows[0].id, "h window 1");
}

TEST_F(CityJsonGlazing, HostileFilesAreErrorsOrWarnings) {
    EXPECT_THAT(read(wallText(R"([{"type":"WallSurface"},{"type":"RoofSurface"},{}])")).error().text(),
                HasSubstr("marked as a window"));
    // Indices beyond the vertices, negative ones, rings that are none.
    const auto broken =
        read(wallText(usual, "MultiSurface", "[[[0,1,2]],[[4,5,99]],[[8,9,10,11]]]", "[0,1,2]"));
    ASSERT_TRUE(broken);
    EXPECT_EQ(broken->windows.size(), 1U);
    EXPECT_EQ(broken->warnings.size(), 1U);
    for (const char* boundaries : {"null", "[1,2,3]", "[[[-1,-2,-3]],[[\"a\",1,2]],[[]]]", "[[[[[[0]]]]]]"})
        EXPECT_FALSE(read(wallText(usual, "MultiSurface", boundaries))) << boundaries;
    for (const char* values : {"null", "[7,8,9]", "[-1,-1,-1]", "[[0],[1],[2]]", "{}"})
        EXPECT_FALSE(read(wallText(usual, "MultiSurface", "[[[0,1,2]],[[4,5,6]],[[8,9,10]]]", values)))
            << values;
    GlazingFileSettings near;
    near.farAwayM = 1;
    city_.frame = Frame({0, 0});
    EXPECT_THAT(read(wallText(usual), near).error().text(), HasSubstr("too far"));
}

}  // namespace
}  // namespace noonmark
