#include "core/io/footprints/build_footprints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/io/pieces/read_part.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

TEST(MapRemarks, AreInAPlannersWords) {
    EXPECT_THAT(makeMapRemark("Non closed ring detected. To avoid accepting it, set ... to NO"),
                testing::HasSubstr("were not closed"));
    EXPECT_THAT(makeMapRemark("organizePolygons() received an unexpected geometry.  Either a polygon ..."),
                testing::HasSubstr("could not be distinguished"));
    EXPECT_EQ(
        makeMapRemark("organizePolygons() received a polygon with more than 100 parts. The processing may be "
                      "really slow."),
        "");
    EXPECT_THAT(makeMapRemark("Something new"), testing::HasSubstr("Something new"));
}

constexpr std::string_view oneClosedOneOpen =
    R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"id":"closed","height":30},"geometry":{"type":"Polygon","coordinates":
[[[-73.98,40.75],[-73.9799,40.75],[-73.9799,40.7501],[-73.98,40.7501],[-73.98,40.75]]]}},
{"type":"Feature","properties":{"id":"open","height":30},"geometry":{"type":"Polygon","coordinates":
[[[-73.98,40.751],[-73.9799,40.751],[-73.9799,40.7511],[-73.98,40.7511]]]}}]})";

TEST(MapRemarks, AnOutlineThatDoesNotCloseIsReadAndSaid) {
    const tests::TemporaryFolder folder;
    NoProgress quiet;
    const auto piece = readFootprints(folder.file("a.geojson", oneClosedOneOpen), {}, quiet, {});
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.size(), 2U);
    const auto said = std::ranges::find(piece->warnings, "a.geojson (1)", &Warning::where);
    ASSERT_NE(said, piece->warnings.end());
    EXPECT_EQ(said->kind, WarningKind::repaired);
    EXPECT_THAT(said->what, testing::HasSubstr("were not closed"));
}

}  // namespace
}  // namespace noonmark
