// Worst spots between the centres of cells, against the same scene on ever finer cells and against shadows
// worked out by hand.

#include "core/review/criteria/worst_spots.h"

#include <gmock/gmock.h>

#include "core/engines/ray/ray_reference.h"
#include "core/review/criteria/criterion_days.h"
#include "core/study/review_study.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/review/paper_days.h"

namespace noonmark {

namespace {

using tests::Box3;

Place streetOf(const Ring& outline) { return {"Street", PlaceKind::street, {{outline, {}}}, "test"}; }

PlaceReview reviewedAt(double cellM, const Rule& rule, const City& city, const Place& place,
                       const std::string& zone, bool refines) {
    NoProgress quiet;
    ReviewSettings settings{cellM, zone, 2026};
    settings.refinesSpots = refines;
    auto study = runReview(rule, city, city, {place}, settings, RayReference(), quiet, {});
    if (!study) throw std::runtime_error(study.error().text());
    return study->places.at(0);
}

// The sun stands still in the south, 45 deg high: a wall of 10 m whose north face lies at y = 0.3 shades up
// to y = 10.3. The place is the strip from the wall to y = 0.9, in cells of 1 m: its only centres, at y =
// 0.5, and all points nearer to the wall are in shadow, for the first of two steps. In the second the sun
// stands 89 deg high, and shadow reaches 10 / tan(89 deg) = 0.17 m from the wall, to y = 0.47: no centre is
// in it.
TEST(WorstSpots, AreFoundBetweenTheCentresOfCells) {
    const City city = tests::cityOf({{{0, -5, 0}, {20, 0.3, 10}}});
    const std::vector<Place> places{streetOf(tests::rectangle(2, 0.3F, 18, 0.9F))};
    const std::array<const City*, 2> cities{&city, &city};
    const PlaceReceivers cells = placeReceiversOnPlaces(cities, places, {.cellM = 1}).value();
    const SunSteps sun = tests::oneDay({{180, 45}, {180, 89}});
    const PlacePoints points = PlacePoints::over(cities, places, cells, {}, sun).value();
    StepMasks masks(cells.cellCount(0), 2);
    for (std::size_t cell = 0; cell < masks.receivers; ++cell) masks.shade(0, cell);
    const PlaceShadow shadow{on(2026, 3, 21), sun.steps, 1, 1, masks, masks};
    const std::vector<SpotSearch> searches{{Quantity::shadow, Measure::spotTotal, {}, false}};
    std::uint32_t maximum = 0;
    for (const PlaceShadow& near : refineWorstSpots(0, shadow, points, searches))
        for (const std::uint32_t steps : countRuns(near, Quantity::shadow, false).total)
            maximum = std::max(maximum, steps);
    EXPECT_EQ(maximum, 2);
}

// In the west a slab in the air shades all centres for the first two of five steps. In the east a wall of
// 1.4 m whose north face lies at y = 0 shades up to y = 1.4 in these steps, with the sun 45 deg high, and up
// to y = 0.272 in the other three, with the sun 79 deg high: the strip at its foot has all five steps, and no
// centre more than two. The row of cells beside it has two, the next none: it may hold four.
TEST(WorstSpots, AreFoundInANookWhoseCentreIsNoWorseThanMany) {
    City city = tests::cityOf({{{42, -5, 0}, {58, 0, 1.4}}});
    city.buildings.push_back(tests::buildingOf({tests::rectangle(-10, -40, 30, -15), {}}, 20, 21, true));
    const std::vector<Place> places{
        {"Streets",
         PlaceKind::street,
         {{tests::rectangle(2, 0, 18, 4), {}}, {tests::rectangle(44, 0, 56, 4), {}}},
         "test"}};
    const std::array<const City*, 2> cities{&city, &city};
    const PlaceReceivers cells = placeReceiversOnPlaces(cities, places, {.cellM = 1}).value();
    const SunSteps sun = tests::oneDay({{180, 45}, {180, 45}, {180, 79}, {180, 79}, {180, 79}});
    const PlacePoints points = PlacePoints::over(cities, places, cells, {}, sun).value();
    StepMasks masks(cells.cellCount(0), 5);
    for (std::size_t cell = 0; cell < masks.receivers; ++cell) {
        const glm::dvec2 centre = points.centreOf(0, cell);
        if (centre.x < 30 || centre.y < 1.4)
            for (const std::size_t step : {0U, 1U}) masks.shade(step, cell);
    }
    PlaceShadow shadow{on(2026, 3, 21), sun.steps, 1, 1, masks, masks};
    shadow.uneven = cells.unevenOf[0];
    shadow.neighbours = cells.neighboursOf[0];
    const std::vector<SpotSearch> searches{{Quantity::shadow, Measure::spotTotal, {}, false}};
    std::uint32_t maximum = 0;
    for (const PlaceShadow& near : refineWorstSpots(0, shadow, points, searches))
        for (const std::uint32_t steps : countRuns(near, Quantity::shadow, false).total)
            maximum = std::max(maximum, steps);
    EXPECT_EQ(maximum, 5);
}

// A hundred pairs of cells beside each other with 2 and 1 steps of shadow, and a cell by itself with 3: a
// spot in the cells with 2 may have 3, no more than the worst centre. A pair with 2 and 0 may hold 4; where
// all pairs have 3 and 2, a hundred cells may hold 4, and not all of them are looked at.
TEST(WorstSpots, AreSuspectedWhereTheirCellsMayHoldMore) {
    constexpr std::uint32_t pairs = 100;
    static_assert(pairs > maxSuspects);
    const std::vector<NeighbourCells> beside{{0, pairs, pairs}};
    PlaceShadow shadow;
    shadow.neighbours = beside;
    std::vector<std::uint32_t> steps(pairs, 2);
    steps.resize(2 * pairs, 1);
    steps.push_back(3);
    EXPECT_TRUE(listSuspects(shadow, Quantity::shadow, steps).cells.empty());
    steps[pairs + 7] = 0;
    const Suspects one = listSuspects(shadow, Quantity::shadow, steps);
    EXPECT_EQ(one.cells, std::vector<std::uint32_t>{7});
    EXPECT_FALSE(one.next);
    for (std::uint32_t pair = 0; pair < pairs; ++pair) steps[pair] = 3, steps[pairs + pair] = 2;
    const Suspects many = listSuspects(shadow, Quantity::shadow, steps);
    EXPECT_EQ(many.cells.size(), maxSuspects);
    EXPECT_EQ(many.next, 4U);
    EXPECT_EQ(listSuspects(shadow, Quantity::sun, steps).next, 1U)
        << "least sun: 2 steps, less the one between";
}

// As before, with points in the place: those of the cells that none lies in may be worse.
TEST(WorstSpots, HaveAnErrorThatIncludesTheCellsWithoutPoints) {
    constexpr int pairs = 100;
    const PaperDay day(on(2026, 3, 21), 480, 1, times(2 * pairs, lit(60)),
                       times(pairs, shaded(30) + lit(30)) + times(pairs, shaded(20) + lit(40)));
    const std::vector<NeighbourCells> beside{{0, pairs, pairs}};
    PlaceShadow shadow = day.shadow;
    shadow.neighbours = beside;
    const Criterion maximum{.quantity = Quantity::shadow, .measure = Measure::spotTotal};
    const std::vector<PlaceShadow> points{day.shadow};
    EXPECT_EQ(measureDay(maximum, DayShadow(shadow, 0, points), false).high, 30 + 1 + 10);
}

TEST(WorstSpots, LieInThePlaceAndOutsideBuildings) {
    const City city = tests::cityOf({{{0, 0, 0}, {10, 10, 10}}});
    const std::vector<Place> places{streetOf(tests::rectangle(5, 5, 12, 8))};
    const std::array<const City*, 2> cities{&city, &city};
    const PlaceReceivers cells = placeReceiversOnPlaces(cities, places, {.cellM = 1}).value();
    const SunSteps sun = tests::oneDay({{180, 45}});
    const PlacePoints points = PlacePoints::over(cities, places, cells, {}, sun).value();
    const std::vector<glm::dvec2> middles{{10.5, 7.5}, {11.5, 5.5}};
    const auto found = points.around(0, middles, {1, 0.25});
    // From x = 10 to 12 (east of the building, in the place) and y = 5 to 8: of the squares of 0.25 m around
    // the first (9.5 to 11.5, 6.5 to 8.5) 6 x 6, around the second (10.5 to 12.5, 4.5 to 6.5) 6 x 6, none
    // twice.
    EXPECT_EQ(found.size(), 72);
    for (const glm::dvec2 point : found) {
        EXPECT_GT(point.x, 10);
        EXPECT_LT(point.x, 12);
        EXPECT_GT(point.y, 5);
        EXPECT_LT(point.y, 8);
    }
}

// A low building stands in a street that is askew to the grid. Its east wall lies along azimuth 162: the sun
// leaves the wall's foot soon after noon, and ground 1 m away half an hour later. So the worst spot is at the
// wall, where no centre of a cell is.
TEST(WorstSpots, OfMontrealsStreetsDoNotDependOnTheCell) {
    const auto askew = [](float x, float y) {
        return glm::vec2(x * 0.951F - y * 0.309F, x * 0.309F + y * 0.951F);  // by 18 deg
    };
    const auto block = [&](float west, float south, float east, float north) {
        return Footprint{{askew(west, south), askew(east, south), askew(east, north), askew(west, north)},
                         {}};
    };
    City city;
    city.frame = Frame({-73.57, 45.5});
    city.buildings = {tests::buildingOf(block(-5, -7, -1, 20), 0, 3)};
    const Place street{"Street", PlaceKind::street, {block(-20, -8, 25, 8)}, "test"};
    const Rule rule = shippedRule("montreal-streets");
    const auto worst = [&](double cellM, bool refines) {
        return *reviewedAt(cellM, rule, city, street, "America/Toronto", refines).results.at(0).value;
    };
    const Measured finest = worst(0.25, true);
    EXPECT_GT(finest.value, 2);
    EXPECT_LT(finest.value, 15);
    for (const double cellM : {2.0, 1.0, 0.5}) {
        const Measured spot = worst(cellM, true), centres = worst(cellM, false);
        EXPECT_NEAR(spot.value, finest.value, 5) << cellM;
        EXPECT_LE(spot.low, finest.value) << cellM;
        EXPECT_GE(spot.high, finest.value) << cellM;
        EXPECT_LE(centres.low, finest.high) << "the error includes the cell, " << cellM;
    }
    EXPECT_GT(worst(2, false).value, finest.value + 10) << "centres alone miss the worst spot";
}

// Cells in a row with 30, 10 and 2 steps of shadow: without points around it the worst may have 20 more.
TEST(WorstSpots, WithoutPointsHaveAnErrorThatIncludesTheirCell) {
    const PaperDay day(on(2026, 3, 21), 480, 1, times(3, lit(60)),
                       {shaded(30) + lit(30), shaded(10) + lit(50), shaded(2) + lit(58)});
    const std::vector<NeighbourCells> row{{0, 1, 2}};
    PlaceShadow shadow = day.shadow;
    shadow.neighbours = row;
    const Criterion maximum{.quantity = Quantity::shadow, .measure = Measure::spotTotal};
    const Measured measured = measureDay(maximum, DayShadow(shadow, 0), false);
    EXPECT_EQ(measured.value, 30);
    EXPECT_EQ(measured.low, 29);
    EXPECT_EQ(measured.high, 30 + 1 + 20);
    const Criterion minimum{.quantity = Quantity::sun, .measure = Measure::spotTotal};
    EXPECT_EQ(measureDay(minimum, DayShadow(shadow, 0), false).low, 30 - 1 - 20);
    const std::vector<PlaceShadow> points{day.shadow};
    EXPECT_EQ(measureDay(maximum, DayShadow(shadow, 0, points), false).high, 31);
}

}  // namespace

}  // namespace noonmark
