#include "core/study/by_place/sun_by_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/city/map_context.h"
#include "core/io/places/read_places.h"
#include "core/study/elements/element_tables.h"
#include "tests/core/study/by_place/place_scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string refusal(const std::vector<Place>& places, const SunByPlaceSettings& settings) {
    NoProgress quiet;
    const auto sun = runSunByPlace(loneTower(), places, settings, quiet, {});
    return sun ? std::string() : sun.error().text();
}

// North of the tower. Cells of 2 m from even to even coordinates lie wholly inside.
TEST(SunByPlace, EqualsEveryRayOverTheSameCells) {
    const Place park = namedPlace("Park", -30, 20, 50, 60);
    const SunByPlace sun = measureByPlace(loneTower(), {park}, settingsOfDays(20));
    StudySettings byRays = settingsOfDays(20).study;
    byRays.region = {"Park", park.polygons};
    byRays.engine = "ray";
    NoProgress quiet;
    const auto rays = runStudy(loneTower(), byRays, quiet, {});
    ASSERT_TRUE(rays);
    double hours = 0, min = 24, max = 0, enough = 0;
    for (const std::uint32_t cell : rays->receivers.cells) {
        const double at = (rays->field.sunlitMinutesPerDay - rays->field.grossMin[cell]) / 60;
        hours += at;
        min = std::min(min, at);
        max = std::max(max, at);
        enough += at >= 6 ? 1 : 0;
    }
    const auto count = double(rays->receivers.cells.size());
    EXPECT_EQ(sun.sun[0].cells, rays->receivers.cells.size());
    EXPECT_DOUBLE_EQ(sun.sun[0].areaM2, 80 * 40);
    EXPECT_NEAR(sun.sun[0].meanHours, hours / count, 0.01);
    EXPECT_NEAR(sun.sun[0].minHours, min, 0.02);
    EXPECT_NEAR(sun.sun[0].maxHours, max, 0.02);
    EXPECT_LT(min, max - 1) << "the tower shades some of it";
    SunByPlaceSettings six = settingsOfDays(20);
    six.enoughHours = 6;
    EXPECT_NEAR(measureByPlace(loneTower(), {park}, six).sun[0].enoughShare, enough / count, 0.01);
}

std::vector<float> listHours(const SunOfPlace& of) {
    std::vector<float> hours;
    for (const SunOfCell& cell : of.ofCells) hours.push_back(cell.hours);
    return hours;
}

// Under the same sun: that of one answer stands over the middle of all its places.
std::vector<float> listHoursInTile(const City& city, std::vector<Place> places, SunByPlaceSettings settings) {
    NoProgress quiet;
    settings.study.region = {"Tile", {{rectangle(0, 0, 200, 200), {}}}};
    const NamedCity alone[]{{{}, city}};
    const auto sun = measurePlacesOfTile(alone, std::move(places), settings,
                                         makeObserver(city, settings.study), quiet, {});
    return listHours(sun.value().baseline.sun[0]);
}

// The sweep computes in blocks of 16 cells, in coordinates of each block. Where they began at the first
// place, single cells differed by a rounding.
TEST(SunByPlace, EveryCellIsTheSameWhicheverPlacesAreMeasuredWithIt) {
    City city = cityOf(randomBoxes(11, 25));
    city.frame = Frame({-73.98, 40.75});
    SunByPlaceSettings settings = settingsOfDays(300);
    settings.study.engine = "horizon";
    settings.study.errorSample.receivers = 0;
    const Place field = namedPlace("Field", -20, -20, 220, 220);
    const std::vector<float> alone = listHoursInTile(city, {field}, settings);
    ASSERT_GT(alone.size(), 5000U);
    EXPECT_LT(std::ranges::min(alone), std::ranges::max(alone) - 1) << "shadow is there to be measured";
    for (const float beside : {-22.0F, -30.0F, -46.0F}) {
        const Place corner = namedPlace("Corner", beside, beside - 4, beside + 2, beside + 2);
        EXPECT_EQ(listHoursInTile(city, {field, corner}, settings), alone) << beside;
    }
}

// Two months of 9 and 11 days.
TEST(SunByPlace, MonthsAddUpToThePeriod) {
    const SunByPlace sun =
        measureByPlace(loneTower(), {namedPlace("Park", -30, 20, 50, 60)}, settingsOfDays(20));
    ASSERT_EQ(sun.months, (std::vector<std::string>{"2026-02", "2026-03"}));
    const std::vector<double>& hours = sun.sun[0].monthHours;
    EXPECT_NEAR((9 * hours[0] + 11 * hours[1]) / 20, sun.sun[0].meanHours, 1e-4);
    EXPECT_LT(hours[0], hours[1]) << "days become longer";
}

// Far south of the tower, whose shadow falls to the north at noon: no shadow but in the early morning.
TEST(SunByPlace, CellsOnTheEdgeCountWithTheirShare) {
    const SunByPlace sun = measureByPlace(City{.frame = Frame({-73.98, 40.75})},
                                          {namedPlace("Odd", 0.5F, 0.25F, 11, 7.5F)}, settingsOfDays(3));
    EXPECT_NEAR(sun.sun[0].areaM2, 10.5 * 7.25, 1e-3);
    EXPECT_NEAR(sun.sun[0].meanHours, sun.possibleHours, 1e-5);
    EXPECT_NEAR(sun.sun[0].minHours, sun.possibleHours, 1e-5);
    EXPECT_EQ(sun.sun[0].enoughShare, 1);
}

TEST(SunByPlace, PlacesOverlapAndEachCountsItsOwnCells) {
    const SunByPlace sun = measureByPlace(
        loneTower(), {namedPlace("Park", -30, 20, 50, 60), namedPlace("Lawn", -30, 20, -10, 40)},
        settingsOfDays(3));
    const SunByPlace lawn =
        measureByPlace(loneTower(), {namedPlace("Lawn", -30, 20, -10, 40)}, settingsOfDays(3));
    EXPECT_EQ(sun.sun[1].cells, 100U);
    EXPECT_NEAR(sun.sun[1].meanHours, lawn.sun[0].meanHours, 0.02);
}

TEST(SunByPlace, DatesStateTheShareWithTooLittle) {
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.dates = {std::chrono::year(2026) / 12 / 21, std::chrono::year(2026) / 6 / 21};
    settings.enoughHours = 5;
    const SunByPlace sun = measureByPlace(loneTower(), {namedPlace("Park", 0, 20, 20, 60)}, settings);
    ASSERT_EQ(sun.sun[0].belowShare.size(), 2U);
    EXPECT_GT(sun.sun[0].belowShare[0], 0.1) << "behind the tower in winter";
    EXPECT_LT(sun.sun[0].belowShare[1], sun.sun[0].belowShare[0]);
}

TEST(SunByPlace, ADayWithoutSunLeavesNothingWithEnough) {
    City city;
    city.frame = Frame({18.95, 69.65});  // Tromso
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.study.period.zone = "Europe/Oslo";
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const SunByPlace sun = measureByPlace(city, {namedPlace("Square", 0, 0, 20, 20)}, settings);
    EXPECT_EQ(sun.sun[0].belowShare, std::vector<double>{1.0});
}

TEST(SunByPlace, APlaceBelowABuildingIsListedAndNotDropped) {
    const SunByPlace sun =
        measureByPlace(loneTower(), {namedPlace("Inside", 4, 4, 16, 16), namedPlace("Park", 0, 20, 20, 60)},
                       settingsOfDays(3));
    ASSERT_EQ(sun.sun.size(), 2U);
    EXPECT_EQ(sun.sun[0].areaM2, 0);
    EXPECT_TRUE(std::isnan(sun.sun[0].meanHours));
    ASSERT_FALSE(sun.warnings.empty());
    EXPECT_EQ(sun.warnings.back().where, "Inside");
    EXPECT_EQ(sun.sun[0].status, PlaceStatus::builtOver);
}

// What a place is listed with in each output.
void expectListed(const SunByPlace& sun, std::size_t place, const std::string& words,
                  const std::string& key) {
    const std::vector<std::string_view> remarks = listRemarks(sun.sun[place]);
    EXPECT_THAT(remarks, testing::ElementsAre(words));
    EXPECT_THAT(toCsv(makeTable(sun)), HasSubstr(words));
    const auto json = nlohmann::json::parse(toJson(sun));
    const auto& of = json["places"][place];
    EXPECT_EQ(of.contains("remarks") ? of["remarks"][0] : of["without_figures"], key);
    EXPECT_THAT(sun.warnings,
                testing::Contains(testing::AllOf(testing::Field(&Warning::where, sun.places[place].name),
                                                 testing::Field(&Warning::what, HasSubstr(words)))));
}

// In the tower.
TEST(SunByPlace, APlaceWithoutCellsIsListedWithTheReason) {
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.smallCellM = 2;
    const SunByPlace sun = measureByPlace(
        loneTower(), {namedPlace("Park", -30, 20, 50, 60), namedPlace("Inside", 4, 4, 16, 16)}, settings);
    expectListed(sun, 1, "buildings stand on all of it", "built_over");
    EXPECT_THAT(listRemarks(sun.sun[0]), IsEmpty());
}

// The terrain ends 100 m east of the tower.
TEST(SunByPlace, APlaceBeyondTheTerrainIsListedAndMeasured) {
    City city = loneTower();
    city.terrain =
        std::make_shared<const Terrain>(Terrain{{-1100, -1100, 60, 20, 20}, std::vector<float>(400, 0)});
    const SunByPlace sun = measureByPlace(
        city, {namedPlace("Park", -30, 20, 50, 60), namedPlace("Far", 150, 0, 190, 40)}, settingsOfDays(3));
    expectListed(sun, 1, "beyond the terrain: the nearest elevation is taken", "beyond_terrain");
    EXPECT_THAT(listRemarks(sun.sun[0]), IsEmpty());
    EXPECT_GT(sun.sun[1].meanHours, 0);
}

TEST(SunByPlace, APlaceOnWaterIsListedAndMeasured) {
    City city = loneTower();
    MapContext map;
    map.areas = {{ContextKind::water, "Lake", {{rectangle(100, 0, 160, 40), {}}}}};
    city.context = std::make_shared<const MapContext>(std::move(map));
    const SunByPlace sun = measureByPlace(
        city, {namedPlace("Park", -30, 20, 50, 60), namedPlace("Lake", 100, 0, 160, 40)}, settingsOfDays(3));
    expectListed(sun, 1, "mostly on water: measured at its surface", "on_water");
    EXPECT_THAT(listRemarks(sun.sun[0]), IsEmpty());
    EXPECT_GT(sun.sun[1].meanHours, 0);
}

TEST(SunByPlace, AZoneFarFromThePlacesIsQuestioned) {
    SunByPlaceSettings far = settingsOfDays(3);
    far.study.period.zone = "Asia/Tokyo";
    far.study.period.window.reset();
    far.study.period.from = std::chrono::hours(23);  // 9 in New York
    EXPECT_THAT(measureByPlace(loneTower(), {namedPlace("Park", 0, 20, 20, 60)}, far).warnings,
                Not(IsEmpty()));
    EXPECT_THAT(measureByPlace(loneTower(), {namedPlace("Park", 0, 20, 20, 60)}, settingsOfDays(3)).warnings,
                IsEmpty());
}

// Winter's days are those of February, spring's those of March; south of the equator they swap names.
TEST(SunByPlace, SeasonsAreNamedByTheirMonths) {
    const SunByPlace sun =
        measureByPlace(loneTower(), {namedPlace("Park", -30, 20, 50, 60)}, settingsOfDays(20));
    ASSERT_EQ(sun.seasons.size(), 2U);
    EXPECT_EQ(sun.seasons[0].label, "Dec to Feb (winter)");
    EXPECT_EQ(sun.sun[0].seasonHours, sun.sun[0].monthHours);
    City south = loneTower();
    south.frame = Frame({18.4, -33.9});
    SunByPlaceSettings settings = settingsOfDays(60);
    settings.study.period.start = std::chrono::year(2026) / 1 / 15;
    settings.study.period.zone = "Africa/Johannesburg";
    const SunByPlace cape = measureByPlace(south, {namedPlace("Park", -30, 20, 50, 60)}, settings);
    EXPECT_EQ(cape.seasons[0].label, "Dec to Feb (summer)");
    const std::vector<double>& hours = cape.sun[0].monthHours;
    EXPECT_NEAR(cape.sun[0].seasonHours[0], (17 * hours[0] + 28 * hours[1]) / 45, 1e-9);
}

// 6 x 6 m, 9 cells of 2 m: half of it lies in the shadow of a wall that 2 m cannot resolve.
TEST(SunByPlace, SmallPlacesHaveFinerCells) {
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60), namedPlace("Yard", 30, 0, 36, 6)};
    const SunByPlace sun = measureByPlace(loneTower(), places, settingsOfDays(3));
    EXPECT_EQ(sun.sun[0].cellM, 2);
    EXPECT_EQ(sun.sun[1].cellM, 0.5);
    EXPECT_EQ(sun.sun[1].cells, 144U);
    EXPECT_DOUBLE_EQ(sun.sun[1].areaM2, 36);
    const SunByPlace fine = measureByPlace(loneTower(), {places[1]}, settingsOfDays(3, 0.5));
    EXPECT_NEAR(sun.sun[1].meanHours, fine.sun[0].meanHours, 0.01);
    SunByPlaceSettings asTheOthers = settingsOfDays(3);
    asTheOthers.smallCellM = 2;
    EXPECT_EQ(measureByPlace(loneTower(), places, asTheOthers).sun[1].cells, 9U);
}

TEST(SunByPlace, PiecesWithoutANameAreFoldedUnderTheirPark) {
    const auto unnamed = [](float west, float south, float east, float north) {
        Place place = namedPlace("", west, south, east, north, PlaceKind::greenstreet);
        place.source = "OSM way 1";
        place.name = "greenstreet (OSM way 1)";
        return place;
    };
    const SunByPlace sun = measureByPlace(
        loneTower(),
        {namedPlace("Park", -30, 20, 50, 60), unnamed(0, 30, 20, 40), unnamed(50.5F, 20, 60, 60),
         unnamed(70, 20, 80, 60), namedPlace("Lawn", 0, 40, 20, 50),
         namedPlace("Road", 60, 20, 70, 60, PlaceKind::street)},
        settingsOfDays(3));
    using Whole = std::optional<std::size_t>;
    EXPECT_EQ(sun.partOf, (std::vector<Whole>{{}, 0, 0, {}, {}, {}}));
}

TEST(SunByPlace, AnotherThresholdGivesTheSharesOfARunWithIt) {
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60)};
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    settings.enoughHours = 2;
    const SunOfCities asked{measureByPlace(loneTower(), places, settings), {}};
    for (const double hours : {0.0, 1.5, 4.1, 6.0, 9.0}) {
        settings.enoughHours = hours;
        const SunByPlace again = measureByPlace(loneTower(), places, settings);
        const auto restated = withEnough(asked, hours);
        ASSERT_TRUE(restated);
        EXPECT_EQ(restated->baseline.settings.enoughHours, hours);
        EXPECT_NEAR(restated->baseline.sun[0].enoughShare, again.sun[0].enoughShare, 1e-6) << hours;
        EXPECT_NEAR(restated->baseline.sun[0].belowShare[0], again.sun[0].belowShare[0], 1e-6) << hours;
        EXPECT_TRUE(haveSameShadow(asked, *restated));
        EXPECT_EQ(errorsJson(restated->baseline.errors).dump(), errorsJson(again.errors).dump()) << hours;
    }
    SunOfCities saved = asked;
    for (SunOfPlace& of : saved.baseline.sun) of.ofCells.clear();
    EXPECT_FALSE(withEnough(saved, 3)) << "its cells are not known";
}

TEST(SunByPlace, RefusesWhatItCannotMeasure) {
    EXPECT_THAT(refusal({}, settingsOfDays(3)), HasSubstr("no place"));
    SunByPlaceSettings tooMuch = settingsOfDays(3);
    tooMuch.enoughHours = 25;
    EXPECT_THAT(refusal({namedPlace("Park", 0, 20, 20, 60)}, tooMuch), HasSubstr("0 to 24"));
    SunByPlaceSettings rays = settingsOfDays(3);
    rays.study.engine = "ray";
    EXPECT_THAT(refusal({namedPlace("Park", 0, 20, 20, 60)}, rays), HasSubstr("sums no months"));
    EXPECT_THAT(refusal({namedPlace("Inside", 4, 4, 16, 16)}, settingsOfDays(3)), HasSubstr("open ground"));
}

}  // namespace
}  // namespace noonmark
