#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "core/city/terrain/building_ground.h"
#include "core/io/osm/read_osm_buildings.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

// Known facts about the shared extract of Midtown Manhattan, which is read once for all tests.
class ReadMidtown : public testing::Test {
protected:
    static void SetUpTestSuite() {
        const auto file = tests::sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
        if (!file) return;
        NoProgress quiet;
        auto result = readOsmFootprints(*file, {}, quiet, {});
        ASSERT_TRUE(result) << result.error().text();
        piece = std::make_unique<FilePiece>(*std::move(result));
    }
    static void TearDownTestSuite() { piece.reset(); }
    void SetUp() override {
        if (!piece) GTEST_SKIP() << "the shared Midtown extract is missing";
    }

    static std::vector<std::string> placesOf(std::string_view what) {
        std::vector<std::string> places;
        for (const Warning& warning : piece->warnings)
            if (warning.what.find(what) != std::string::npos) places.push_back(warning.where);
        return places;
    }
    static const Building* buildingWith(const std::string& partId) {
        for (const auto& building : piece->buildings)
            for (const Part& part : building->parts)
                if (part.sourceId == partId) return building.get();
        return nullptr;
    }

    static std::unique_ptr<FilePiece> piece;
};
std::unique_ptr<FilePiece> ReadMidtown::piece;

// 7,989 features are buildings, 5,674 parts, 161 both: 13,502 in all.
TEST_F(ReadMidtown, EveryFeatureIsDrawnReplacedOrReported) {
    EXPECT_EQ(piece->format, "OpenStreetMap PBF");
    std::set<std::string> seen;
    for (const auto& building : piece->buildings) {
        seen.insert(building->sourceId);
        for (const Part& part : building->parts) seen.insert(part.sourceId);
    }
    for (const Warning& warning : piece->warnings)
        if (warning.kind == WarningKind::dropped || warning.kind == WarningKind::leftOut)
            seen.insert(warning.where);
    EXPECT_EQ(seen.size(), 13502U);
}

TEST_F(ReadMidtown, KnowsItsTallest) {
    const Building* empireState = buildingWith("way 137425145");
    ASSERT_NE(empireState, nullptr);
    EXPECT_FLOAT_EQ(topM(*empireState), 443.2F);
    std::vector<float> tops;
    for (const Part& part : empireState->parts) tops.push_back(part.topM);
    EXPECT_THAT(tops, testing::IsSupersetOf({320.0F, 390.0F, 443.2F}));
    const Building* vanderbilt = buildingWith("way 265875648");
    ASSERT_NE(vanderbilt, nullptr);
    EXPECT_EQ(vanderbilt->name, "One Vanderbilt");
    EXPECT_FLOAT_EQ(topM(*vanderbilt), 397);
    for (const auto& building : piece->buildings) EXPECT_LE(topM(*building), 443.2F);
}

TEST_F(ReadMidtown, EveryInvalidMultipolygonIsReported) {
    std::set<std::string> reported;
    for (const Warning& warning : piece->warnings)
        if (warning.kind == WarningKind::dropped || warning.kind == WarningKind::repaired)
            reported.insert(warning.where);
    for (const int way : {42496479,  148241074, 159912554, 163465867, 243088864,  250474275, 250474293,
                          250489417, 250489740, 250489923, 263313917, 263313921,  265430674, 265432778,
                          265432779, 265943078, 265943080, 266149305, 266170541,  280446697, 291324482,
                          291732259, 370530884, 380769523, 406779017, 1195001805, 1196264427})
        EXPECT_TRUE(reported.contains(fmt::format("way {}", way))) << way;
    EXPECT_TRUE(reported.contains("relation 1860567"));
}

TEST_F(ReadMidtown, OddTagsAreReportedWithTheirText) {
    EXPECT_THAT(placesOf("lies underground"), testing::SizeIs(4));
    // A canopy of 5.1 m and a glass tower part of 30 m, both in layer -1.
    EXPECT_THAT(placesOf("its layer lies below the ground"),
                testing::UnorderedElementsAre("way 264656693", "way 283108472"));
    EXPECT_THAT(placesOf("min_height that cannot be read"), testing::ElementsAre(HasSubstr("5;5.5")));
    EXPECT_THAT(placesOf("storeys that cannot be read"), testing::Contains(HasSubstr("concrete")));
    EXPECT_THAT(placesOf("its underside is not below its top"), testing::SizeIs(3));
    EXPECT_THAT(placesOf("its roof is not flat"), testing::SizeIs(441));
    EXPECT_TRUE(placesOf("km from the middle").empty());
}

TEST_F(ReadMidtown, CourtyardsAreOpen) {
    std::set<std::string> open;
    for (const auto& building : piece->buildings)
        for (const Part& part : building->parts)
            if (!part.footprint.holes.empty()) open.insert(part.sourceId);
    EXPECT_GE(open.size(), 30U);  // of the 39 with holes some are outlines that were replaced by their parts
}

TEST_F(ReadMidtown, HeightsSayWhereTheyComeFrom) {
    std::map<HeightSource, int> count;
    for (const auto& building : piece->buildings)
        for (const Part& part : building->parts) ++count[part.heightSource];
    EXPECT_GT(count[HeightSource::measured], 12500);
    EXPECT_GT(count[HeightSource::levels], 50);
    EXPECT_LT(count[HeightSource::assumed], 400);
    EXPECT_EQ(count[HeightSource::mesh], 0);
}

// 57 are tagged building=roof, one of them in layer -1.
TEST_F(ReadMidtown, CanopiesHang) {
    EXPECT_GE(placesOf("a roof without walls").size(), 50U);
    for (const std::string& id : placesOf("a roof without walls")) {
        const Building* building = buildingWith(id);
        ASSERT_NE(building, nullptr) << id;
        EXPECT_TRUE(std::ranges::find(building->parts, id, &Part::sourceId)->isOverhanging) << id;
    }
}

}  // namespace
}  // namespace noonmark
