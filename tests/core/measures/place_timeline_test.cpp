#include "core/measures/places/place_timeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/city/trees/tree.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/shade_trees.h"
#include "core/measures/places/place_run.h"
#include "core/measures/places/place_sums.h"
#include "core/samples/sample_city.h"
#include "core/study/place_study.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using namespace std::chrono_literals;
using testing::HasSubstr;

constexpr Instant noon{std::chrono::sys_days{std::chrono::March / 21 / 2026} + 12h};
constexpr CivilDate equinox{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};

// Steps of two minutes from noon on, in the slots given.
std::vector<SunStep> stepsIn(const std::vector<int>& slots) {
    std::vector<SunStep> steps;
    for (const int slot : slots) {
        SunStep& step = steps.emplace_back();
        step.slot = slot;
        step.at = noon + slot * 2min;
    }
    return steps;
}

// Masks from rows of text, one character a cell: '#' in shadow.
StepMasks masksFrom(const std::vector<std::string>& rows) {
    StepMasks masks(rows.front().size(), rows.size());
    for (std::size_t step = 0; step < rows.size(); ++step)
        for (std::size_t cell = 0; cell < rows[step].size(); ++cell)
            if (rows[step][cell] == '#') masks.shade(step, cell);
    return masks;
}

PlaceShadow shadowOf(const std::vector<SunStep>& steps, const std::vector<std::string>& baseline,
                     const std::vector<std::string>& scenario) {
    return {equinox, steps, 4, 2, masksFrom(baseline), masksFrom(scenario)};
}

// Four cells of 4 m2, steps of 2 min. Incremental, step by step: -, b, bc, (gap) c, -, cd.
TEST(PlaceTimeline, OfADayWorkedOutByHand) {
    const std::vector<SunStep> steps = stepsIn({0, 1, 2, 5, 6, 7});
    const DayTimeline day = computeTimeline(shadowOf(steps, {"#...", "#...", "#...", "##..", "##..", "##.."},
                                                     {"....", ".#..", "###.", "###.", "##..", "####"}));
    EXPECT_EQ(day.areaM2, 16);
    EXPECT_EQ(day.sunlitMinutes, 12);
    EXPECT_EQ(day.stepMinutes, 2);
    ASSERT_EQ(day.steps.size(), 6U);
    EXPECT_EQ(day.steps[1].baselineM2, 4);
    EXPECT_EQ(day.steps[1].scenarioM2, 4);
    EXPECT_EQ(day.steps[1].incrementalM2, 4);
    EXPECT_EQ(day.steps[1].gainedM2, 4);
    EXPECT_EQ(day.steps[2].incrementalM2, 8);
    const ShadowOnPlace& more = day.incremental;
    const std::vector<TimeSpan> spans{
        {noon + 2min, noon + 6min}, {noon + 10min, noon + 12min}, {noon + 14min, noon + 16min}};
    EXPECT_EQ(more.intervals, spans);
    EXPECT_EQ(more.enters(), noon + 2min);
    EXPECT_EQ(more.exits(), noon + 16min);
    EXPECT_EQ(more.minutes, 8);
    EXPECT_EQ(more.largestM2, 8);
    EXPECT_EQ(more.largestAt, noon + 4min);
    EXPECT_DOUBLE_EQ(more.areaHoursM2, (4 + 8 + 4 + 8) * 2 / 60.0);
    ASSERT_TRUE(more.longest);  // the second cell in steps 1 and 2; the third one's time has a gap
    EXPECT_EQ(more.longest->minutes, 4);
    EXPECT_EQ(more.longest->cell, 1U);
    EXPECT_EQ(more.longest->when, (TimeSpan{noon + 2min, noon + 6min}));
    EXPECT_EQ(more.longest->errorMin, 2) << "a step; no cell is known to lie beside another";
    EXPECT_EQ(day.gained.minutes, 4);
    EXPECT_EQ(day.fullCoverMin, 2);
    EXPECT_EQ(day.allSunTakenMin, 2);
    EXPECT_DOUBLE_EQ(day.theoreticalM2h(), 16 * 12 / 60.0);
}

// Cells in a row that are in shadow for 5, 3 and 1 of the steps; the last has its centre beside the place.
TEST(PlaceTimeline, ALongestStayMayBeLongerByWhatLiesBetweenCells) {
    const std::vector<SunStep> steps = stepsIn({0, 1, 2, 3, 4, 5});
    const std::vector<std::string> rows{"###", "##.", "##.", "#..", "#..", "..."};
    PlaceShadow shadow = shadowOf(steps, rows, rows);
    const std::vector<NeighbourCells> row{{0, 1, 2}};
    shadow.neighbours = row;
    EXPECT_EQ(computeTimeline(shadow).baseline.longest->errorMin, 2 * (1 + 2)) << "2 steps, and one";
    const std::vector<WeightedCell> uneven{{1, -0.5, true}};
    shadow.uneven = uneven;
    EXPECT_EQ(computeTimeline(shadow).baseline.longest->errorMin, 2) << "the cell beside it is no spot";
}

TEST(PlaceTimeline, APlaceWithoutShadowOrWithoutCellsHasNone) {
    const std::vector<SunStep> steps = stepsIn({0, 1});
    const DayTimeline lit = computeTimeline(shadowOf(steps, {"..", ".."}, {"..", ".."}));
    EXPECT_FALSE(lit.scenario.enters());
    EXPECT_FALSE(lit.scenario.longest);
    EXPECT_FALSE(lit.scenario.largestAt);
    const DayTimeline none = computeTimeline({equinox, steps, 1, 2, StepMasks(0, 2), StepMasks(0, 2)});
    EXPECT_EQ(none.fullCoverMin, 0);
    EXPECT_EQ(none.theoreticalM2h(), 0);
    const DayTimeline night = computeTimeline({equinox, {}, 1, 2, StepMasks(3, 0), StepMasks(3, 0)});
    EXPECT_EQ(night.sunlitMinutes, 0);
}

TEST(MaskRuns, TheLongestRunOfAColumnIsThatOfCountingOneByOne) {
    std::mt19937 random(4);
    for (int round = 0; round < 200; ++round) {
        const std::size_t rows = 1 + random() % 70, words = 1 + random() % 9;
        std::vector<std::uint64_t> bits(rows * words);
        std::vector<BitRow> bitRows;
        for (std::size_t row = 0; row < rows; ++row) bitRows.push_back({&bits[row * words], nullptr});
        const int kind = round % 3;
        for (std::uint64_t& word : bits) {
            word = std::uint64_t(random()) << 32U | random();
            if (kind > 0) word |= std::uint64_t(random()) << 32U | random();
            if (kind > 1) word |= ~(std::uint64_t(random()) << 32U & random());
        }
        std::size_t longest = 0;
        for (std::size_t column = 0; column < words * 64; ++column)
            for (std::size_t row = 0, run = 0; row < rows; ++row) {
                run = (bits[row * words + column / 64] >> (column % 64) & 1) != 0 ? run + 1 : 0;
                longest = std::max(longest, run);
            }
        const auto found = findLongestColumnRun(bitRows, words);
        ASSERT_EQ(found ? found->length : 0, longest);
        if (!found) continue;
        for (std::size_t row = found->row; row < found->row + longest; ++row)
            EXPECT_TRUE(bits[row * words + found->column / 64] >> (found->column % 64) & 1);
    }
    const std::uint64_t none[2]{}, some[2]{5, 1};
    EXPECT_FALSE(findLongestColumnRun(std::vector<BitRow>{{none}, {}, {some, some}}, 2));
    EXPECT_FALSE(findLongestColumnRun({}, 2));
}

TEST(MaskRuns, OfEquallyLongRunsTheEarliestIsTakenAndThenTheFirstColumn) {
    // Runs of two rows: column 300 in rows 1 and 2, columns 310 and 20 in rows 2 and 3.
    std::vector<std::uint64_t> bits(std::size_t{4} * 5);
    const auto set = [&](std::size_t row, std::size_t column) {
        bits[row * 5 + column / 64] |= std::uint64_t{1} << column % 64;
    };
    for (const std::size_t row : {1, 2}) set(row, 300);
    for (const std::size_t row : {2, 3})
        for (const std::size_t column : {310, 20}) set(row, column);
    std::vector<BitRow> rows;
    for (std::size_t row = 0; row < 4; ++row) rows.push_back({&bits[row * 5], nullptr});
    const ColumnRun earliest = findLongestColumnRun(rows, 5).value();
    EXPECT_EQ(earliest.row, 1U);
    EXPECT_EQ(earliest.column, 300U);
    EXPECT_EQ(earliest.length, 2U);
    rows[1] = {};
    EXPECT_EQ(findLongestColumnRun(rows, 5).value().column, 20U);
}

TEST(PlaceSums, AddUpByMonthAndQuarterAndNameTheDayOfMost) {
    PlaceSums sums;
    for (const unsigned day : {20U, 21U, 22U}) {
        DayTimeline one{.day = std::chrono::year{2026} / std::chrono::March / day, .areaM2 = 100};
        one.sunlitMinutes = 600;
        one.scenario.areaHoursM2 = day == 21 ? 50 : 20;
        one.incremental.areaHoursM2 = day == 22 ? 7 : 5;
        one.incremental.largestM2 = double(day);
        one.incremental.largestAt = noon;
        sums.add(one);
    }
    EXPECT_DOUBLE_EQ(sums.all().theoreticalM2h, 3000);
    EXPECT_DOUBLE_EQ(sums.all().shareOf(sums.all().scenarioM2h), 90 / 3000.0);
    EXPECT_EQ(sums.months().at("2026-03").days, 3);
    EXPECT_EQ(sums.quarters()[std::size_t(Quarter::fromDecember)].days, 1);
    EXPECT_EQ(sums.quarters()[std::size_t(Quarter::fromMarch)].days, 2);
    EXPECT_EQ(unsigned(sums.maxScenarioDay()->day.day()), 21U);
    EXPECT_EQ(unsigned(sums.maxIncrementalDay()->day.day()), 22U);
    EXPECT_EQ(sums.largestIncrementalM2(), 22);
}

Place squareAt(std::string name, float west, float south, float side) {
    return {
        std::move(name), PlaceKind::park, {{rectangle(west, south, west + side, south + side), {}}}, "drawn"};
}

// A tower of 20 m x 20 m and 100 m, and the sun due south at 45 deg: its shadow reaches 100 m north of
// its northern wall, 20 m wide. The park of 40 m begins 80 m north of that wall: 20 m x 20 m of it are
// shaded.
TEST(PlaceStudy, OfATowerUnderASunThatStandsStill) {
    const City empty = cityOf({{{500, 500, 0}, {501, 501, 1}}});
    City built = empty;
    built.buildings.push_back(buildingOf({{0, 0, 0}, {20, 20, 100}}));
    const std::vector<Place> places{squareAt("park", 0, 100, 40), squareAt("lot", 0, 0, 20)};
    const City* const cities[]{&empty, &built};
    const auto cells = placeReceiversOnPlaces(cities, places, {.cellM = 1}).value();
    EXPECT_EQ(cells.cellCount(0), 1600U);
    EXPECT_EQ(cells.cellCount(1), 0U);  // the tower covers it
    SunSteps sun = oneDay({{180, 45}, {180, 45}, {180, 45}});
    for (std::size_t i = 0; i < 3; ++i) sun.steps[i].at = noon + i * 1min;
    NoProgress quiet;
    std::vector<DayTimeline> days;
    const auto take = [&](std::size_t, std::span<const PlaceShadow> shadows) -> Result<void> {
        for (const PlaceShadow& shadow : shadows) days.push_back(computeTimeline(shadow));
        return {};
    };
    ASSERT_TRUE(shadePlaces(ProjectedShadows(), empty, &built, cells, sun, take, quiet, {}));
    ASSERT_EQ(days.size(), 2U);
    EXPECT_NEAR(days[0].incremental.largestM2, 400, 21);  // a row or column at the edges
    EXPECT_EQ(days[0].incremental.minutes, 3);
    EXPECT_EQ(days[0].baseline.minutes, 0);
    EXPECT_EQ(days[0].incremental.longest->minutes, 3);
    EXPECT_EQ(days[1].areaM2, 0);
}

std::shared_ptr<const Trees> plantTrees(const std::vector<glm::dvec2>& places, float leafOffTransmissivity) {
    Trees trees{{}, {100, 300}, true};
    for (const glm::dvec2 place : places)
        trees.trees.push_back({.place = place,
                               .heightM = 10,
                               .crownBaseM = 3,
                               .crownDiameterM = 8,
                               .leafOnTransmissivity = 0.1F,
                               .leafOffTransmissivity = leafOffTransmissivity});
    return std::make_shared<const Trees>(trees);
}

// Two trees in a park, one of them in the scenario alone, and a sun that stands still: at each step the areas
// are those of rays on the same cells.
TEST(PlaceStudy, WeighsCrownsAtEachStep) {
    City before = cityOf({{{10, 100, 0}, {14, 104, 8}}});
    const auto plant = [](const std::vector<glm::dvec2>& places) { return plantTrees(places, 0.6F); };
    before.trees = plant({{10, 110}});
    City after = before;
    after.trees = plant({{10, 110}, {30, 120}});
    const City* const cities[]{&before, &after};
    const std::vector<Place> places{squareAt("park", 0, 100, 40)};
    const auto cells = placeReceiversOnPlaces(cities, places, {.cellM = 1}).value();
    SunSteps sun = oneDay({{180, 45}, {180, 45}});
    sun.days[0].date = std::chrono::year(2026) / 1 / 15;
    for (std::size_t i = 0; i < 2; ++i) sun.steps[i].at = noon + i * 1min;
    NoProgress quiet;
    const PlaceTrees trees(before, &after, cells, sun);
    EXPECT_EQ(trees.treesUsed(), 2U);
    DayTimeline without;
    PlaceTrees::Shaded shaded;
    const auto take = [&](std::size_t day, std::span<const PlaceShadow> shadows) -> Result<void> {
        without = computeTimeline(shadows[0]);
        shaded = trees.shade(0, day, shadows[0], without, {}, {});
        return {};
    };
    ASSERT_TRUE(shadePlaces(ProjectedShadows(), before, &after, cells, sun, take, quiet, {}));
    const auto areaM2 = [&](const City& city, TreeColumns column) {
        const ShadowField field = RayReference().accumulate(city, cells.receivers, sun, quiet, {}).value();
        double sum = 0;
        for (const std::uint32_t cell : cells.receivers.cells)
            sum += double(fieldOfColumn(field, column).grossMin[cell]) / 2;  // of two minutes
        return sum;
    };
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal}) {
        const DayTimeline& day = column == TreeColumns::evergreen ? shaded.evergreen : shaded.seasonal;
        ASSERT_EQ(day.steps.size(), 2U);
        const double was = areaM2(before, column), is = areaM2(after, column);
        EXPECT_GT(was, without.steps[0].baselineM2 + 5);
        EXPECT_NEAR(day.steps[0].baselineM2, was, 1e-3 * was);
        EXPECT_NEAR(day.steps[1].scenarioM2, is, 1e-3 * is);
        EXPECT_NEAR(day.steps[0].incrementalM2, is - was, 1e-3 * is) << "a tree takes nothing away";
        EXPECT_NEAR(day.steps[0].gainedM2, 0, 1e-6);
        EXPECT_NEAR(day.scenario.areaHoursM2, 2 * is / 60, 1e-3 * is);
        EXPECT_NEAR(day.scenario.largestM2, is, 1e-3 * is);
    }
    EXPECT_LT(shaded.seasonal.steps[0].scenarioM2, shaded.evergreen.steps[0].scenarioM2);
}

// One tree that stands and one that is planted, and a sun that stands still for two minutes: the middles of
// their shadows, 6.5 m north of the stems, are dark, and what lies between the stems is not.
TEST(PlaceStudy, HasTimesAndCoversOfCellsThatCrownsDarken) {
    const auto plant = [](const std::vector<glm::dvec2>& places) { return plantTrees(places, 0.9F); };
    City before, after;
    before.trees = plant({{10, 110}});
    after.trees = plant({{10, 110}, {30, 120}});
    const City* const cities[]{&before, &after};
    const std::vector<Place> places{squareAt("below the old tree", 9, 115, 3),
                                    squareAt("below the new tree", 29, 125, 3), squareAt("lit", 18, 112, 4)};
    const auto cells = placeReceiversOnPlaces(cities, places, {.cellM = 1}).value();
    SunSteps sun = oneDay({{180, 45}, {180, 45}});
    sun.days[0].date = std::chrono::year(2026) / 1 / 15;
    for (std::size_t i = 0; i < 2; ++i) sun.steps[i].at = noon + i * 1min;
    NoProgress quiet;
    const PlaceTrees trees(before, &after, cells, sun);
    std::vector<DayTimeline> without;
    std::vector<PlaceTrees::Shaded> with;
    const auto take = [&](std::size_t day, std::span<const PlaceShadow> shadows) -> Result<void> {
        for (std::size_t i = 0; i < shadows.size(); ++i) {
            without.push_back(computeTimeline(shadows[i]));
            with.push_back(trees.shade(i, day, shadows[i], without.back(), {}, {}));
        }
        return {};
    };
    ASSERT_TRUE(shadePlaces(ProjectedShadows(), before, &after, cells, sun, take, quiet, {}));
    const DayTimeline &old = with[0].evergreen, &fresh = with[1].evergreen, &lit = with[2].evergreen;
    EXPECT_EQ(without[0].fullCoverMin, 0);
    EXPECT_EQ(old.fullCoverMin, 2);
    EXPECT_EQ(old.allSunTakenMin, 0) << "the baseline has the tree, too";
    EXPECT_EQ(old.baseline.enters(), noon);
    EXPECT_EQ(old.baseline.exits(), noon + 2min);
    EXPECT_EQ(old.baseline.longest->minutes, 2);
    EXPECT_LT(old.baseline.areaHoursM2, old.areaM2 * 2 / 60) << "areas are weighted";
    EXPECT_EQ(old.incremental.minutes, 0);
    EXPECT_EQ(fresh.fullCoverMin, 2);
    EXPECT_EQ(fresh.allSunTakenMin, 2);
    EXPECT_EQ(fresh.baseline.minutes, 0);
    EXPECT_EQ(fresh.incremental.minutes, 2);
    EXPECT_EQ(fresh.incremental.longest->minutes, 2);
    EXPECT_TRUE(lit.scenario.intervals.empty());
    EXPECT_FALSE(lit.scenario.longest);
    for (const PlaceTrees::Shaded& bare : with) {
        EXPECT_EQ(bare.seasonal.scenario.minutes, 0) << "bare crowns take less than half";
        EXPECT_EQ(bare.seasonal.fullCoverMin, 0);
    }
    EXPECT_GT(with[1].seasonal.incremental.areaHoursM2, 0);
}

// Enters and exits to the step and areas to the cell, on parks among the blocks of the grid sample.
TEST(PlaceStudy, AgreesWithRaysOnEveryCellAndStep) {
    const City before = makeGridSample({.buildings = 400}).value();
    City after = before;
    after.buildings.push_back(buildingOf({{30, -20, 0}, {60, 10, 150}}));
    const std::vector<Place> places{squareAt("a", -150, 60, 60), squareAt("b", 10, 30, 90),
                                    squareAt("inside b", 30, 40, 20), squareAt("c", 150, 120, 50)};
    PlaceStudySettings settings{.period = {.start = equinox, .stepMinutes = 5, .window = SolarHours{}}};
    NoProgress quiet;
    const auto fast = runPlaceStudy(before, &after, places, settings, ProjectedShadows(), quiet, {}).value();
    const auto rays = runPlaceStudy(before, &after, places, settings, RayReference(), quiet, {}).value();
    std::size_t steps = 0, different = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const DayTimeline &a = fast.places[i].days.front(), &b = rays.places[i].days.front();
        ASSERT_EQ(a.steps.size(), b.steps.size());
        EXPECT_EQ(a.incremental.intervals, b.incremental.intervals) << places[i].name;
        EXPECT_EQ(a.scenario.intervals, b.scenario.intervals) << places[i].name;
        EXPECT_EQ(a.fullCoverMin, b.fullCoverMin);
        for (std::size_t step = 0; step < a.steps.size(); ++step, ++steps) {
            EXPECT_NEAR(a.steps[step].scenarioM2, b.steps[step].scenarioM2, 1) << step;
            EXPECT_NEAR(a.steps[step].incrementalM2, b.steps[step].incrementalM2, 1) << step;
            different += a.steps[step].scenarioM2 != b.steps[step].scenarioM2 ? 1 : 0;
        }
    }
    EXPECT_LE(different, steps / 100);
    EXPECT_GT(fast.places[1].sums.all().incrementalM2h, 0);
    // A place inside another has the same shadow there as alone.
    const auto alone =
        runPlaceStudy(before, &after, {places[2]}, settings, ProjectedShadows(), quiet, {}).value();
    EXPECT_EQ(alone.places[0].days[0].scenario.areaHoursM2, fast.places[2].days[0].scenario.areaHoursM2);
}

TEST(PlaceStudy, WhatIsWrongIsReported) {
    const City city = cityOf({{{0, 0, 0}, {20, 20, 10}}});
    PlaceStudySettings settings{.period = {.start = equinox, .stepMinutes = 30, .window = SolarHours{}}};
    NoProgress quiet;
    EXPECT_THAT(runPlaceStudy(city, nullptr, {}, settings, ProjectedShadows(), quiet, {}).error().text(),
                HasSubstr("no place"));
    const auto covered =
        runPlaceStudy(city, nullptr, {squareAt("covered", 5, 5, 5)}, settings, ProjectedShadows(), quiet, {});
    EXPECT_EQ(covered.value().warnings.size(), 1U);
    settings.period.stepMinutes = 1000;
    EXPECT_FALSE(
        runPlaceStudy(city, nullptr, {squareAt("a", 50, 5, 5)}, settings, ProjectedShadows(), quiet, {}));
}

}  // namespace
}  // namespace noonmark
