#include "app/gui/tools/live/live_change.h"

#include <gtest/gtest.h>

#include <QStringList>

#include "app/gui/tools/preview/edit_preview.h"
#include "tests/gui/live_scene.h"

namespace noonmark {
namespace {

using namespace test;

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

// 4 x 2 cells of 10 m, row 0 in the south.
constexpr Grid grid{0, 0, 10, 4, 2};

Receivers receiversOf(const std::vector<CellKind>& kind) {
    Receivers receivers{.grid = grid, .kind = kind};
    for (std::uint32_t cell = 0; cell < kind.size(); ++cell)
        if (isReceiver(kind[cell])) receivers.cells.push_back(cell);
    return receivers;
}

ShadowField fieldOf(const std::vector<float>& grossMin) {
    ShadowField field{.grid = grid};
    field.grossMin = grossMin;
    field.continuousMin.assign(grossMin.size(), unknown);
    field.sunlitMinutesPerDay = 600;
    return field;
}

Place placeAt(const std::string& name, float west, float south, float eastM, float northM) {
    Footprint outline;
    outline.outer = {
        {west, south}, {west + eastM, south}, {west + eastM, south + northM}, {west, south + northM}};
    return {name, PlaceKind::park, {outline}, {}};
}

bool sameMinutes(const std::vector<float>& a, const std::vector<float>& b) {
    return std::ranges::equal(
        a, b, [](float one, float other) { return one == other || (std::isnan(one) && std::isnan(other)); });
}

constexpr CellKind g = CellKind::ground, b = CellKind::building, r = CellKind::roof, o = CellKind::outside;

TEST(LiveChange, CountsOpenGroundAloneAndFindsTheWorstSpot) {
    const Receivers before = receiversOf({g, g, g, b, r, g, g, o});
    const Receivers after = receiversOf({g, b, g, g, r, r, g, o});
    // Two cells gain 20 and 90 minutes, one loses 40; what was or became building or roof does not count.
    const LiveChange change =
        computeLiveChange(before, fieldOf({0, 5, 10, unknown, 9, 0, 50, unknown}), after,
                          fieldOf({20, unknown, 100, 7, 99, 88, 10, unknown}), {});
    EXPECT_EQ(change.worst, 2U);
    EXPECT_EQ(change.figures[0].thresholdMin, 30);
    EXPECT_EQ(change.figures[1].thresholdMin, 60);
    EXPECT_DOUBLE_EQ(change.figures[0].gross.moreShadowM2, 100);
    EXPECT_DOUBLE_EQ(change.figures[0].gross.anyMoreShadowM2, 200);
    EXPECT_DOUBLE_EQ(change.figures[0].gross.lessShadowM2, 100);
    EXPECT_DOUBLE_EQ(change.figures[1].gross.lessShadowM2, 0);
    EXPECT_DOUBLE_EQ(change.figures[0].gross.maxMoreShadowMin, 90);
    EXPECT_DOUBLE_EQ(change.figures[0].receiverAreaM2, 300);
    EXPECT_DOUBLE_EQ(change.figures[0].becameBuildingM2, 200) << "under the tower, and under its roof";
    EXPECT_DOUBLE_EQ(change.figures[0].becameGroundM2, 100);
}

TEST(LiveChange, WithoutNewShadowThereIsNoWorstSpot) {
    const Receivers open = receiversOf(std::vector<CellKind>(8, g));
    const std::vector<float> minutes(8, 30);
    const LiveChange change = computeLiveChange(open, fieldOf(minutes), open, fieldOf(minutes), {});
    EXPECT_FALSE(change.worst);
    EXPECT_EQ(describeEffect(change, {}), "No new shadow");
}

TEST(LiveChange, PlacesComeInTheOrderOfTheirNewShadow) {
    const std::vector<Place> places{placeAt("Far park", 500, 0, 10, 10), placeAt("Calm park", 0, 0, 10, 10),
                                    placeAt("Small park", 10, 0, 10, 10),
                                    placeAt("Long park", 20, 0, 40, 20)};
    const auto cells = findPlaceCells(places, grid);
    ASSERT_EQ(cells.size(), 3U) << "one lies beyond the grid";
    EXPECT_TRUE(cells[0].whole);
    EXPECT_EQ(cells[1].cells, std::vector<std::uint32_t>{1});
    EXPECT_FALSE(cells[2].whole) << "it reaches 20 m beyond the grid";
    EXPECT_EQ(cells[2].cells, (std::vector<std::uint32_t>{2, 3, 6, 7}));
    const Receivers open = receiversOf(std::vector<CellKind>(8, g));
    const LiveChange change = computeLiveChange(open, fieldOf(std::vector<float>(8, 0)), open,
                                                fieldOf({0, 80, 31, 31, 0, 0, 0, 0}), cells);
    ASSERT_EQ(change.places.size(), 2U) << "the calm park gains none";
    EXPECT_EQ(change.places[0].name, "Long park");
    EXPECT_EQ(describeEffect(change, "Rule: 1 fail").split('\n'),
              (QStringList{"New shadow a day, by cells of 10.0 m: 300 m² over 30 min, 100 m² over 60 min",
                           "Worst spot: +80 min a day",
                           "Long park: 200 m² over 30 min, up to +31 min (of the part that is measured)",
                           "Small park: 100 m² over 30 min, up to +80 min",
                           "The change reaches beyond the ground that is measured", "Rule: 1 fail"}));
}

struct LiveBaselineTest : ::testing::Test {
    NoProgress progress;
    std::shared_ptr<SharedHorizonCache> horizons = std::make_shared<SharedHorizonCache>();

    LiveAnswer answer(const City& rest, const City& baseline, const LiveQuestion& question,
                      ShadowCounts counts = ShadowCounts::grossAndRuns) {
        LivePlace place = placeIn(rest);
        place.baseline = std::make_shared<const City>(baseline);
        const auto live = LiveShadow::at(place, question, horizons, progress, {}).value();
        return live->with(tower(), counts, progress, {}).value();
    }
};

// The change of the live shadow is that of a comparison of both cities.
TEST_F(LiveBaselineTest, IsTheDifferenceOfBothCities) {
    const City city = smallCity(), proposed = with(city, tower());
    StudySettings study;
    study.period = spring(1, 2);
    study.receivers.cellM = 1;
    study.engine = "projected";
    study.region = makeRegionFromLocalBox({glm::vec2(-165, -215), glm::vec2(235, 185)});
    const LiveQuestion question{{study.period, makeObserver(city, study)}, {}, {.cellM = 1}};
    const LiveAnswer live = answer(city, city, question);
    ASSERT_TRUE(live.change);
    const auto impact = runImpact(city, proposed, {study, false}, progress, {}).value();
    ASSERT_EQ(impact.total.grid, live.change->impact.grid);
    EXPECT_TRUE(sameMinutes(impact.total.grossMin, live.change->impact.grossMin));
    EXPECT_TRUE(sameMinutes(impact.total.continuousMin, live.change->impact.continuousMin));
    EXPECT_EQ(impact.total.change, live.change->impact.change);
    EXPECT_GT(live.change->figures[0].gross.moreShadowM2, 1000);
}

// A tower that is designed again is compared with the city before it, not with the city without it.
TEST_F(LiveBaselineTest, TheBaselineMayHaveOtherBuildings) {
    const City city = smallCity();
    const LiveQuestion question{sunOf(spring(1, 2)), {}, {.cellM = 1}};
    const LiveAnswer same = answer(city, with(city, tower()), question);
    ASSERT_TRUE(same.change);
    EXPECT_FALSE(same.change->worst) << "the baseline has the same tower";
    EXPECT_EQ(same.change->figures[0].gross.anyLessShadowM2, 0);
    EXPECT_EQ(same.change->figures[0].becameBuildingM2, 0);
    const LiveAnswer lost = answer(city, with(city, tower(100)), question);
    EXPECT_GT(lost.change->figures[0].gross.anyLessShadowM2, 100) << "where the other tower's shadow is gone";
    EXPECT_EQ(lost.change->figures[0].becameGroundM2, 900);
}

TEST_F(LiveBaselineTest, OnTerrainContinuousShadowIsComparedWhenItIsCounted) {
    const City city = smallCityOnASlope();
    const LiveQuestion question{sunOf(spring(1, 5)), {}, {.cellM = 1}};
    const LiveAnswer gross = answer(city, city, question, ShadowCounts::gross);
    ASSERT_TRUE(gross.change);
    EXPECT_TRUE(std::isnan(gross.change->figures[0].continuous.meanMin));
    const LiveAnswer runs = answer(city, city, question);
    EXPECT_GT(runs.change->figures[0].continuous.anyMoreShadowM2, 0);
    EXPECT_TRUE(sameBits(gross.change->impact.grossMin, runs.change->impact.grossMin));
}

TEST_F(LiveBaselineTest, RoofsAloneHaveNoChange) {
    const City city = smallCity();
    LiveQuestion question{sunOf(spring(1, 5)), {}, {.cellM = 1, .places = ReceiverPlaces::roofs}};
    EXPECT_FALSE(answer(city, city, question).change);
    question.receivers.places = ReceiverPlaces::both;
    EXPECT_TRUE(answer(city, city, question).change) << "the ground has";
}

}  // namespace
}  // namespace noonmark
