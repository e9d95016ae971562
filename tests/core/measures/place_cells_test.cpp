// Cells of places, weighed by what of them lies in the place, against areas that are known.

#include "core/measures/places/place_cells.h"

#include <gmock/gmock.h>

#include "core/city/map_context.h"
#include "core/engines/ray/ray_reference.h"
#include "core/measures/places/place_run.h"
#include "core/measures/places/place_sums.h"
#include "core/measures/places/place_timeline.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

Place placeOver(Footprint polygon) { return {"green", PlaceKind::park, {std::move(polygon)}, "drawn"}; }

double areaOf(const PlaceReceivers& cells, std::size_t place) {
    PlaceShadow shadow{.cellAreaM2 = cells.receivers.grid.cellAreaM2(), .uneven = cells.unevenOf[place]};
    shadow.baseline = StepMasks(cells.cellCount(place), 0);
    return shadow.areaM2();
}

PlaceReceivers cellsOf(const City& city, const Place& place, double cellM) {
    const City* const cities[]{&city};
    return placeReceiversOnPlaces(cities, std::span(&place, 1), {.cellM = cellM}).value();
}

TEST(PlaceCells, AddUpToThePlaceOnAGridThatDoesNotFitIt) {
    const City empty;
    const Footprint box{rectangle(0.3F, 0.2F, 10.7F, 5.9F), {}};  // 10.4 x 5.7 m
    const Footprint triangle{{{0.3F, 0.4F}, {17.1F, 3.7F}, {5.2F, 12.6F}}, {}};
    const Footprint ring{rectangle(-7.4F, -3.3F, 9.1F, 8.2F), {{{0, 0}, {0, 3.5F}, {2.5F, 3.5F}, {2.5F, 0}}}};
    for (const double cellM : {0.25, 1.0, 3.0}) {
        EXPECT_NEAR(areaOf(cellsOf(empty, placeOver(box), cellM), 0), 10.4 * 5.7, 1e-3) << cellM;
        EXPECT_NEAR(areaOf(cellsOf(empty, placeOver(triangle), cellM), 0), area(triangle), 1e-3) << cellM;
        EXPECT_NEAR(areaOf(cellsOf(empty, placeOver(ring), cellM), 0), 16.5 * 11.5 - 3.5 * 2.5, 1e-3)
            << cellM;
    }
}

TEST(PlaceCells, OfANarrowPlaceBetweenCentresAreThoseItTouches) {
    // 0.4 m wide, between the centres of two rows of cells: no centre lies in it.
    const PlaceReceivers cells = cellsOf({}, placeOver({rectangle(0, 0.55F, 20, 0.95F), {}}), 1);
    EXPECT_EQ(cells.cellCount(0), 20U);
    EXPECT_NEAR(areaOf(cells, 0), 8, 1e-4);
}

// A pond belongs to its park, and a lake may itself be the place whose sunlight matters.
TEST(PlaceCells, KeepTheWaterOfAPlace) {
    MapContext map;
    map.areas = {{ContextKind::water, "Pond", {{rectangle(2, 2, 8, 8), {}}}}};
    City city;
    city.context = std::make_shared<const MapContext>(map);
    EXPECT_NEAR(areaOf(cellsOf(city, placeOver({rectangle(0, 0, 10, 10), {}}), 1), 0), 100, 1e-3);
    EXPECT_NEAR(areaOf(cellsOf(city, placeOver({rectangle(3, 3, 7, 7), {}}), 1), 0), 16, 1e-3);
}

TEST(PlaceCells, LeaveOutWhatIsBuiltOnAndGiveTheRestToTheNextCell) {
    // The wall at x = 4.8 leaves 0.2 m of the cells from 4 to 5, whose centres are in the building.
    const City city = cityOf({{{0, -5, 0}, {4.8, 20, 10}}});
    const PlaceReceivers cells = cellsOf(city, placeOver({rectangle(2, 0, 10, 10), {}}), 1);
    EXPECT_EQ(cells.cellCount(0), 50U);
    EXPECT_NEAR(areaOf(cells, 0), 5.2 * 10, 1e-3);
    for (const WeightedCell& cell : cells.unevenOf[0]) EXPECT_NEAR(cell.extra, 0.2, 1e-4);
    EXPECT_EQ(cells.unevenOf[0].size(), 10U);
}

TEST(PlaceCells, OfAPlaceUnderABuildingAreNone) {
    const City city = cityOf({{{0.3, 0.3, 0}, {20.6, 20.6, 100}}});
    EXPECT_EQ(cellsOf(city, placeOver({rectangle(0.3F, 0.3F, 20.6F, 20.6F), {}}), 1).cellCount(0), 0U);
}

TEST(PlaceAreas, WeighEachCellByItsShare) {
    // Three cells of 4 m2; the second counts half, the third one and a half times.
    const std::vector<WeightedCell> uneven{{1, -0.5}, {2, 0.5}};
    PlaceShadow shadow{.cellAreaM2 = 4, .uneven = uneven};
    shadow.baseline = StepMasks(3, 1);
    shadow.scenario = StepMasks(3, 1);
    shadow.baseline.shade(0, 0);
    shadow.scenario.shade(0, 1);
    shadow.scenario.shade(0, 2);
    const StepAreas areas = weighStep(shadow, 0, countStep(shadow.baseline.at(0), shadow.scenario.at(0)));
    EXPECT_DOUBLE_EQ(areas.baselineM2, 4);
    EXPECT_DOUBLE_EQ(areas.scenarioM2, 8);
    EXPECT_DOUBLE_EQ(areas.incrementalM2, 8);
    EXPECT_DOUBLE_EQ(areas.gainedM2, 4);
    EXPECT_DOUBLE_EQ(shadow.areaM2(), 12);
}

TEST(PlaceAreas, OfCellsBesideThePlaceCountForNoTime) {
    // The place begins at x = 0.7: the centres of its first cells lie beside it, at x = 0.5.
    const PlaceReceivers cells = cellsOf({}, placeOver({rectangle(0.7F, 0, 3, 1), {}}), 1);
    ASSERT_EQ(cells.cellCount(0), 3U);
    PlaceShadow shadow{.cellAreaM2 = 1, .uneven = cells.unevenOf[0]};
    const SunSteps sun = oneDay({{180, 45}, {180, 45}});
    shadow.steps = sun.steps;
    shadow.baseline = StepMasks(3, 2);
    shadow.scenario = StepMasks(3, 2);
    shadow.scenario.shade(0, 0);
    shadow.scenario.shade(1, 1);
    const DayTimeline day = computeTimeline(shadow);
    EXPECT_NEAR(day.steps[0].incrementalM2, 0.3, 1e-5);
    EXPECT_EQ(day.incremental.minutes, 1) << "the second step alone, on a centre in the place";
    EXPECT_EQ(day.incremental.longest->cell, 1U);
    EXPECT_EQ(countCentres(shadow), 2U);
}

TEST(PlaceAreas, CountTheEdgesOfAShadow) {
    // 90 x 90 cells, of which 70 x 10 are in shadow: 70 pairs along each long side, 10 along each short one.
    const PlaceReceivers cells = cellsOf({}, placeOver({rectangle(0, 0, 90, 90), {}}), 1);
    StepMasks mask(cells.cellCount(0), 1);
    for (std::size_t row = 20; row < 30; ++row)
        for (std::size_t column = 5; column < 75; ++column) mask.shade(0, row * 90 + column);
    EXPECT_EQ(countEdges(mask.at(0), cells.neighboursOf[0]), 2U * (70 + 10));
}

// The sun stands in the south, 45 deg high: north of its wall a slab 12.3 m wide shades a rectangle of 12.3 m
// by its height, which fits no grid.
TEST(PlaceAreas, OfAShadowLieWithinTheBoundOfItsEdges) {
    const City empty = cityOf({{{500, 500, 0}, {501, 501, 1}}});
    for (const double east : {0.0, 0.13, 0.37, 0.5, 0.71})
        for (const double tall : {20.0, 20.4, 20.6}) {
            City built = empty;
            built.buildings.push_back(buildingOf({{east, 0, 0}, {east + 12.3, 7.1, tall}}));
            const Place place = placeOver({rectangle(-10.3F, 7.1F, 30.2F, 60.4F), {}});
            const City* const cities[]{&empty, &built};
            const PlaceReceivers cells =
                placeReceiversOnPlaces(cities, std::span(&place, 1), {.cellM = 1}).value();
            EXPECT_NEAR(areaOf(cells, 0), 40.5 * 53.3, 0.01);
            const SunSteps sun = oneDay({{180, 45}});
            NoProgress quiet;
            const auto take = [&](std::size_t, std::span<const PlaceShadow> shadows) -> Result<void> {
                const PlaceShadow& shadow = shadows.front();
                const DayTimeline day = computeTimeline(shadow);
                const double bound =
                    double(countEdges(shadow.scenario.at(0), shadow.neighbours)) / 2 * shadow.cellAreaM2;
                EXPECT_NEAR(day.scenario.largestM2, 12.3 * tall, bound) << east << ' ' << tall;
                EXPECT_LT(bound, 0.2 * 12.3 * tall);
                return {};
            };
            ASSERT_TRUE(shadePlaces(RayReference(), empty, &built, cells, sun, take, quiet, {}));
        }
}

}  // namespace
}  // namespace noonmark
