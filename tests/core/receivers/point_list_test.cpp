#include "core/receivers/points/point_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace noonmark {
namespace {

using testing::HasSubstr;

TEST(PointLists, HaveColumnsInAnyOrder) {
    const auto points =
        parsePointList("name;Facing;lat;lon;note\nA;180;40.75;-73.98;x\nB;;40.76;-73.97;\n", "a.csv").value();
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0], (ListedPoint{"A", {-73.98, 40.75}, {}, 180.0}));
    EXPECT_EQ(points[1], (ListedPoint{"B", {-73.97, 40.76}, {}, {}}));
}

TEST(PointLists, NeedNoHeading) {
    const auto points = parsePointList("-73.98,40.75\n-73.97,40.76,4.5,270\n", "a.csv").value();
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0], (ListedPoint{"point 1", {-73.98, 40.75}, {}, {}}));
    EXPECT_EQ(points[1], (ListedPoint{"point 2", {-73.97, 40.76}, 4.5, 270.0}));
}

TEST(PointLists, AreReadAsTheyAreWritten) {
    const std::vector<ListedPoint> points{
        {"a, \"b\"", {-73.98, 40.75}, {}, {}}, {"c", {1.5, -2.5}, 3.0, {}}, {"d", {0, 0}, {}, 90.0}};
    EXPECT_EQ(parsePointList(toCsv(points), "points").value(), points);
}

TEST(PointLists, SayWhereTheyAreWrong) {
    const auto errorOf = [](const char* text) { return parsePointList(text, "a.csv").error().text(); };
    EXPECT_THAT(errorOf(""), HasSubstr("no points"));
    EXPECT_THAT(errorOf("id,lon,lat\n"), HasSubstr("no points"));
    EXPECT_THAT(errorOf("id,x1,y1\na,1,2\n"), HasSubstr("no columns lon and lat"));
    EXPECT_THAT(errorOf("1,2\n1,95\n"), HasSubstr("a.csv, line 2"));
    EXPECT_THAT(errorOf("1,2\n1\n"), HasSubstr("a.csv, line 2"));
    EXPECT_THAT(errorOf("1,2,-4\n"), HasSubstr("'-4' is not a height"));
    EXPECT_THAT(errorOf("1,2,4,400\n"), HasSubstr("'400' is not an azimuth"));
    EXPECT_THAT(errorOf("1,2,high\n"), HasSubstr("'high' is not a height"));
    EXPECT_THAT(errorOf("id,lon,lat\na,1,2\na,3,4\n"), HasSubstr("Two points have the id 'a'"));
}

TEST(ListedPoints, AreReadFromOneText) {
    EXPECT_EQ(parsePoint("-73.98,40.75,4.5,180").value(), (ListedPoint{"", {-73.98, 40.75}, 4.5, 180.0}));
    EXPECT_EQ(parsePoint("-73.98,40.75,,180").value(), (ListedPoint{"", {-73.98, 40.75}, {}, 180.0}));
    for (const char* text : {"", "1", "1,2,3,4,5", "a,b", "1,2\n3,4", "inf,2"})
        EXPECT_FALSE(parsePoint(text)) << text;
}

}  // namespace
}  // namespace noonmark
