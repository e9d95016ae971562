#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/io/places/read_places.h"
#include "tests/core/study/by_place/place_scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::IsEmpty;

TEST(SunByPlace, EachDateHasItsOwnError) {
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.study.engine = "horizon";
    settings.dates = {std::chrono::year(2026) / 12 / 21, std::chrono::year(2026) / 6 / 21};
    const SunByPlace sun = measureByPlace(loneTower(), {namedPlace("Park", -30, 20, 50, 60)}, settings);
    ASSERT_EQ(sun.dateErrors.size(), 2U);
    ASSERT_TRUE(sun.dateErrors[0] && sun.dateErrors[1]);
    EXPECT_NE(sun.dateErrors[0]->gross.wholeMin, sun.dateErrors[1]->gross.wholeMin);
    EXPECT_LT(sun.dateErrors[0]->gross.percent(sun.dateErrors[0]->gross.meanMin), 1);
}

std::vector<std::string> quantitiesOf(const std::vector<ShownError>& errors) {
    std::vector<std::string> quantities;
    for (const ShownError& error : errors) quantities.emplace_back(error.facts.key);
    return quantities;
}

const ShownError* findError(const SunByPlace& sun, std::string_view quantity) {
    const auto at = std::ranges::find(sun.errors, quantity, [](const auto& one) { return one.facts.key; });
    return at == sun.errors.end() ? nullptr : &*at;
}

// Four cells, all of which are sampled. Few bins make the error visible.
TEST(SunByPlace, TheErrorOfAMeanIsHowFarItIsOffRays) {
    const Place corner = namedPlace("Corner", 20, 20, 24, 24);
    SunByPlaceSettings settings = settingsOfDays(20);
    settings.smallCellM = 2;
    settings.study.engine = "horizon";
    settings.study.engineSettings["bin"] = 2;
    const SunByPlace sun = measureByPlace(loneTower(), {corner}, settings);
    StudySettings byRays = settingsOfDays(20).study;
    byRays.region = {"Corner", corner.polygons};
    byRays.engine = "ray";
    NoProgress quiet;
    const auto rays = runStudy(loneTower(), byRays, quiet, {});
    ASSERT_TRUE(rays) << rays.error().text();
    ASSERT_EQ(rays->receivers.cells.size(), 4U);
    const double hours = (rays->field.sunlitMinutesPerDay - rays->statistics.meanGrossMin) / 60;
    const ShownError* mean = findError(sun, "place_mean");
    ASSERT_NE(mean, nullptr);
    EXPECT_GT(mean->mean, 0);
    EXPECT_NEAR(mean->mean, 60 * std::abs(sun.sun[0].meanHours - hours), 1e-3);
    EXPECT_EQ(mean->mean, mean->largest) << "of one place";
    const ShownError* month = findError(sun, "place_month");
    ASSERT_NE(month, nullptr);
    EXPECT_EQ(month->count, 2U);
    EXPECT_GE(month->largest, mean->mean);
}

// The park lies north of the wall, the far place where nothing of it can be seen.
class SunByPlaceBy : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Engines, SunByPlaceBy, testing::Values("horizon", "projected"));

TEST_P(SunByPlaceBy, ChangesEqualThoseOfCitiesMeasuredApart) {
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.study.engine = GetParam();
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60),
                                    namedPlace("Far", -400, -400, -360, -360)};
    const SunOfCities both =
        compareByPlace({{"Now", loneTower()}, {"Wall", withSouthWall(loneTower())}}, places, settings);
    const SunByPlace alone = measureByPlace(withSouthWall(loneTower()), places, settings);
    ASSERT_EQ(both.compared.size(), 1U);
    const ComparedSun& wall = both.compared[0];
    EXPECT_EQ(wall.sun.name, "Wall");
    EXPECT_DOUBLE_EQ(wall.sun.sun[0].meanHours, alone.sun[0].meanHours);
    EXPECT_DOUBLE_EQ(wall.sun.sun[0].monthHours[0], alone.sun[0].monthHours[0]);
    EXPECT_DOUBLE_EQ(wall.changes[0].meanHours, alone.sun[0].meanHours - both.baseline.sun[0].meanHours);
    EXPECT_LT(wall.changes[0].meanHours, -3) << "the wall takes most of the day";
    EXPECT_GT(wall.changes[0].maxLossMin, -60 * wall.changes[0].meanHours);
    EXPECT_EQ(wall.changes[0].maxGainMin, 0);
    EXPECT_GT(wall.changes[0].lostShare, 0.9);
    EXPECT_EQ(wall.changes[1].meanHours, 0);
    EXPECT_EQ(wall.changes[1].maxLossMin, 0);
    EXPECT_EQ(wall.changes[1].lostShare, 0);
}

TEST(SunByPlace, EachQuantityHasAnErrorOfItsOwn) {
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.study.engine = "horizon";
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60),
                                    namedPlace("Far", -400, -400, -360, -360)};
    const SunOfCities both =
        compareByPlace({{"Now", loneTower()}, {"Wall", withSouthWall(loneTower())}}, places, settings);
    std::vector<std::string> expected{"cell_sun",     "place_mean", "place_month",
                                      "place_enough", "place_date", "place_below"};
    EXPECT_EQ(quantitiesOf(both.baseline.errors), expected);
    expected.insert(expected.begin() + 4, {"place_change", "cell_change", "place_lost"});
    EXPECT_EQ(quantitiesOf(both.compared[0].sun.errors), expected);
    EXPECT_EQ(findError(both.baseline, "place_date")->of, "2026-12-21");
    EXPECT_GE(findError(both.compared[0].sun, "cell_change")->p99,
              findError(both.compared[0].sun, "cell_change")->mean);
    EXPECT_LT(findError(both.compared[0].sun, "place_change")->largest, 5);
    settings.study.errorSample.receivers = 0;
    EXPECT_THAT(measureByPlace(loneTower(), places, settings).errors, IsEmpty());
}

// Of 9 m2, with 36 cells of 0.5 m.
TEST(SunByPlace, PlacesWithSmallCellsHaveAnErrorOfTheirOwn) {
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.study.engine = "horizon";
    settings.study.engineSettings["bin"] = 2;
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60), namedPlace("Corner", 4, 22, 7, 25)};
    const SunByPlace sun = measureByPlace(loneTower(), places, settings);
    ASSERT_EQ(sun.sun[1].cellM, 0.5);
    const ShownError* error = findError(sun, "place_small");
    ASSERT_NE(error, nullptr);
    EXPECT_EQ(error->count, 1U) << "there is one small place";
    EXPECT_LT(error->largest, 20);
    settings.smallCellM = 2;
    EXPECT_EQ(findError(measureByPlace(loneTower(), places, settings), "place_small"), nullptr);
}

/// What is reported, as long as it rises.
class RisingOnly final : public Progress {
public:
    void report(double fraction, std::string_view) override {
        const std::lock_guard lock(mutex_);
        if (fraction < last_) fell_ = true;
        last_ = fraction;
    }
    [[nodiscard]] bool fell() const { return fell_; }
    [[nodiscard]] double last() const { return last_; }

private:
    std::mutex mutex_;
    double last_ = 0;
    bool fell_ = false;
};

// The sweep of the second city covers the receivers that its wall reaches; small places come after all.
TEST_P(SunByPlaceBy, ProgressRisesToTheEndInSeveralCities) {
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.study.engine = GetParam();
    settings.dates = {std::chrono::year(2026) / 12 / 21, std::chrono::year(2026) / 6 / 21};
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60), namedPlace("Small", 22, 22, 27, 27),
                                    namedPlace("Far", -2000, -400, -1995, -395)};
    const NamedCity cities[]{
        {"Now", loneTower()}, {"Wall", withSouthWall(loneTower())}, {"Same", loneTower()}};
    RisingOnly progress;
    ASSERT_TRUE(compareSunByPlace(cities, places, settings, progress, {}));
    EXPECT_FALSE(progress.fell());
    EXPECT_GT(progress.last(), 0.9);
    EXPECT_LE(progress.last(), 1);
}

// A building of the scenario stands on a fifth of the park: that ground counts in neither city.
TEST(SunByPlace, CitiesAreComparedOnGroundThatIsOpenInAllOfThem) {
    City built = loneTower();
    built.buildings.push_back(buildingOf(Box3{{34, 20, 0}, {50, 60, 3}}));
    const SunOfCities both = compareByPlace({{"Now", loneTower()}, {"Built", built}},
                                            {namedPlace("Park", -30, 20, 50, 60)}, settingsOfDays(3));
    EXPECT_DOUBLE_EQ(both.baseline.sun[0].areaM2, 64 * 40);
    EXPECT_DOUBLE_EQ(both.compared[0].sun.sun[0].areaM2, 64 * 40);
}

}  // namespace
}  // namespace noonmark
