#include "core/study/by_place/sun_by_place.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/base/gdal_calls.h"
#include "core/city/map_context.h"
#include "core/city/trees/tree.h"
#include "core/io/places/read_places.h"
#include "core/receivers/place_names.h"
#include "core/study/elements/element_tables.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

City tower() {
    City city = cityOf({{{0, 0, 0}, {20, 20, 60}}});
    city.frame = Frame({-73.98, 40.75});
    return city;
}

Place namedPlace(const std::string& name, float west, float south, float east, float north,
                 PlaceKind kind = PlaceKind::park) {
    return {name, kind, {{rectangle(west, south, east, north), {}}}, "made up"};
}

SunByPlaceSettings ofDays(int days, double cellM = 2) {
    SunByPlaceSettings settings;
    settings.study.receivers.cellM = cellM;
    settings.study.period = {.start = std::chrono::year(2026) / 2 / 20,
                             .days = days,
                             .stepMinutes = 10,
                             .window = SolarHours{},
                             .zone = "America/New_York"};
    return settings;
}

SunByPlace measured(const City& city, const std::vector<Place>& places, const SunByPlaceSettings& settings) {
    NoProgress quiet;
    auto sun = runSunByPlace(city, places, settings, quiet, {});
    EXPECT_TRUE(sun) << (sun ? "" : sun.error().text());
    return sun ? *std::move(sun) : SunByPlace{};
}

std::string refusal(const std::vector<Place>& places, const SunByPlaceSettings& settings) {
    NoProgress quiet;
    const auto sun = runSunByPlace(tower(), places, settings, quiet, {});
    return sun ? std::string() : sun.error().text();
}

// North of the tower. Cells of 2 m from even to even coordinates lie wholly inside.
TEST(SunByPlace, EqualsEveryRayOverTheSameCells) {
    const Place park = namedPlace("Park", -30, 20, 50, 60);
    const SunByPlace sun = measured(tower(), {park}, ofDays(20));
    StudySettings byRays = ofDays(20).study;
    byRays.region = {"Park", park.polygons};
    byRays.engine = "ray";
    NoProgress quiet;
    const auto rays = runStudy(tower(), byRays, quiet, {});
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
    SunByPlaceSettings six = ofDays(20);
    six.enoughHours = 6;
    EXPECT_NEAR(measured(tower(), {park}, six).sun[0].enoughShare, enough / count, 0.01);
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
    SunByPlaceSettings settings = ofDays(300);
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

// A roof of leaves from 5 to 10 m, 2 km to all sides.
City underLeaves() {
    City city;
    city.frame = Frame({-73.98, 40.75});
    const Tree roof{.place = {0, 0},
                    .heightM = 10,
                    .crownBaseM = 5,
                    .crownDiameterM = 4000,
                    .shape = CrownShape::cylinder,
                    .leafOnTransmissivity = 0.5F,
                    .leafOffTransmissivity = 0.8F};
    city.trees = std::make_shared<const Trees>(Trees{{roof}, {100, 300}});
    return city;
}

// Hours of sun a day that such leaves let through: Beer-Lambert along the path between 5 and 10 m, up to
// their edge, per metre as the transmissivity over the mean chord 4 V / S = 2 r h / (r + h).
double hoursThroughLeaves(const SunSteps& sun, double transmissivity) {
    const double perM = -std::log(transmissivity) / (2 * 2000.0 * 5 / (2000 + 5));
    double minutes = 0;
    for (const SunStep& step : sun.steps) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(step.direction));
        const double across = std::hypot(direction.x, direction.y), perTan = across / direction.z;
        const double path = std::max(0.0, std::min(10 * perTan, 2000.0) - 5 * perTan) / across;
        minutes += sun.stepMinutes * std::exp(-perM * path);
    }
    return minutes / 60 / double(sun.dayCount());
}

TEST(SunByPlace, UnderLeavesIsWhatTheyLetThrough) {
    SunByPlaceSettings settings = ofDays(20);
    settings.dates = {std::chrono::year(2026) / 7 / 1, std::chrono::year(2026) / 12 / 21};
    settings.enoughHours = 4;
    const SunByPlace sun = measured(underLeaves(), {namedPlace("Street", -10, -10, 10, 10)}, settings);
    ASSERT_EQ(sun.withTrees.size(), 2U);
    const SunOfPlace &evergreen = sun.withTrees[0].sun[0], &seasonal = sun.withTrees[1].sun[0];
    EXPECT_EQ(sun.withTrees[0].column, TreeColumns::evergreen);
    const double inLeaf = hoursThroughLeaves(sun.daylight, 0.5), bare = hoursThroughLeaves(sun.daylight, 0.8);
    EXPECT_GT(bare, inLeaf + 1);
    EXPECT_NEAR(evergreen.meanHours, inLeaf, 0.02);
    EXPECT_NEAR(evergreen.minHours, inLeaf, 0.02);
    EXPECT_NEAR(seasonal.meanHours, bare, 0.02) << "February and March are out of season";
    EXPECT_NEAR(sun.sun[0].meanHours, sun.possibleHours, 1e-5);
    EXPECT_NEAR((9 * evergreen.monthHours[0] + 11 * evergreen.monthHours[1]) / 20, inLeaf, 0.02);
    EXPECT_EQ(seasonal.dateHours[0], evergreen.dateHours[0]) << "in leaf in July";
    EXPECT_GT(seasonal.dateHours[1], evergreen.dateHours[1] + 0.5) << "bare in December";
    EXPECT_EQ(evergreen.enoughShare, inLeaf >= 4 ? 1 : 0);
    EXPECT_EQ(evergreen.areaM2, sun.sun[0].areaM2);
    EXPECT_TRUE(std::ranges::any_of(sun.errors, [](const ShownError& error) {
        return error.facts.key == "place_mean" && error.of == "trees as evergreens" && error.largest < 0.05;
    }));
}

City avenue() {
    City city = tower();
    std::vector<Tree> trees;
    for (int x = -28; x < 50; x += 7)
        trees.push_back({.place = {double(x), 40},
                         .heightM = 12,
                         .crownBaseM = 3,
                         .crownDiameterM = 9,
                         .evergreen = x % 2 == 0,
                         .leafOnTransmissivity = 0.1F,
                         .leafOffTransmissivity = 0.7F});
    city.trees = std::make_shared<const Trees>(Trees{std::move(trees), {100, 300}});
    return city;
}

TEST(SunByPlace, WithTreesEqualsTheColumnsOfAStudyOverTheSameCells) {
    const Place park = namedPlace("Park", -30, 20, 50, 60);
    SunByPlaceSettings settings = ofDays(20);
    settings.study.engine = "horizon";
    const SunByPlace sun = measured(avenue(), {park}, settings);
    StudySettings same = settings.study;
    same.region = {"Park", park.polygons};
    same.engine = "ray";
    NoProgress quiet;
    const auto study = runStudy(avenue(), same, quiet, {});
    ASSERT_TRUE(study);
    const auto columns = listShadeColumns(study->field);
    ASSERT_EQ(columns.size(), sun.withTrees.size());
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const auto& cells = study->receivers.cells;
        double hours = 0, least = 24;
        for (const std::uint32_t cell : cells) {
            const double at =
                (study->field.sunlitMinutesPerDay - double(columns[column].field->grossMin[cell])) / 60;
            hours += at / double(cells.size());
            least = std::min(least, at);
        }
        const SunOfPlace& of = sun.withTrees[column].sun[0];
        EXPECT_EQ(sun.withTrees[column].column, columns[column].column);
        EXPECT_NEAR(of.meanHours, hours, 0.01);
        EXPECT_NEAR(of.minHours, least, 0.03);
        EXPECT_LT(of.meanHours, sun.sun[0].meanHours - 0.1);
    }
}

TEST(SunByPlace, WithoutATreeInReachNothingIsAdded) {
    const Place park = namedPlace("Park", -30, 20, 50, 60);
    const SunByPlace bare = measured(tower(), {park}, ofDays(3));
    City far = tower();
    far.trees = std::make_shared<const Trees>(Trees{{{.place = {90'000, 0}}}, {100, 300}});
    const SunByPlace sun = measured(far, {park}, ofDays(3));
    EXPECT_TRUE(sun.withTrees.empty());
    EXPECT_EQ(toCsv(makeTable(sun)), toCsv(makeTable(bare)));
    const SunByPlace with = measured(avenue(), {park}, ofDays(3));
    EXPECT_THAT(with.field.grossMin, testing::Pointwise(testing::NanSensitiveFloatEq(), bare.field.grossMin));
    SunByPlaceSettings without = ofDays(3);
    without.study.trees = TreeColumns::without;
    EXPECT_TRUE(measured(avenue(), {park}, without).withTrees.empty());
}

TEST(SunByPlace, PlantingAnAvenueTakesSunOnlyWithTrees) {
    const NamedCity cities[]{{"Before", tower()}, {"Avenue", avenue()}};
    SunByPlaceSettings settings = ofDays(3);
    settings.lossMin = 30;
    NoProgress quiet;
    const SunOfCities all =
        compareSunByPlace(cities, {namedPlace("Park", -30, 20, 50, 60)}, settings, quiet, {}).value();
    ASSERT_EQ(all.compared.size(), 1U);
    const ComparedSun& planted = all.compared[0];
    EXPECT_EQ(planted.changes[0].meanHours, 0);
    ASSERT_EQ(planted.changesWithTrees.size(), 2U);
    const SunChange &evergreen = planted.changesWithTrees[0][0], &seasonal = planted.changesWithTrees[1][0];
    EXPECT_EQ(all.baseline.withTrees[0].sun[0].meanHours, all.baseline.sun[0].meanHours);
    EXPECT_LT(evergreen.meanHours, seasonal.meanHours);
    EXPECT_LT(seasonal.meanHours, -0.1);
    EXPECT_GT(evergreen.lostShare, 0.05);
    const std::string csv = toCsv(makeTable(all.baseline, all.compared));
    EXPECT_THAT(csv, HasSubstr("change_hours_evergreen_avenue"));
    const auto json = nlohmann::json::parse(toJson(all.baseline, all.compared));
    EXPECT_NEAR(json["places"][0]["scenarios"]["Avenue"]["change_hours_seasonal"].get<double>(),
                seasonal.meanHours, 1e-4);
    const SunOfCities less = withEnough(all, 1).value();
    EXPECT_EQ(less.compared[0].sun.withTrees[0].sun[0].enoughShare,
              computeEnoughShare(planted.sun.withTrees[0].sun[0], 1));
}

// Two months of 9 and 11 days.
TEST(SunByPlace, MonthsAddUpToThePeriod) {
    const SunByPlace sun = measured(tower(), {namedPlace("Park", -30, 20, 50, 60)}, ofDays(20));
    ASSERT_EQ(sun.months, (std::vector<std::string>{"2026-02", "2026-03"}));
    const std::vector<double>& hours = sun.sun[0].monthHours;
    EXPECT_NEAR((9 * hours[0] + 11 * hours[1]) / 20, sun.sun[0].meanHours, 1e-4);
    EXPECT_LT(hours[0], hours[1]) << "days become longer";
}

// Far south of the tower, whose shadow falls to the north at noon: no shadow but in the early morning.
TEST(SunByPlace, CellsOnTheEdgeCountWithTheirShare) {
    const SunByPlace sun = measured(City{.frame = Frame({-73.98, 40.75})},
                                    {namedPlace("Odd", 0.5F, 0.25F, 11, 7.5F)}, ofDays(3));
    EXPECT_NEAR(sun.sun[0].areaM2, 10.5 * 7.25, 1e-3);
    EXPECT_NEAR(sun.sun[0].meanHours, sun.possibleHours, 1e-5);
    EXPECT_NEAR(sun.sun[0].minHours, sun.possibleHours, 1e-5);
    EXPECT_EQ(sun.sun[0].enoughShare, 1);
}

TEST(SunByPlace, PlacesOverlapAndEachCountsItsOwnCells) {
    const SunByPlace sun = measured(
        tower(), {namedPlace("Park", -30, 20, 50, 60), namedPlace("Lawn", -30, 20, -10, 40)}, ofDays(3));
    const SunByPlace lawn = measured(tower(), {namedPlace("Lawn", -30, 20, -10, 40)}, ofDays(3));
    EXPECT_EQ(sun.sun[1].cells, 100U);
    EXPECT_NEAR(sun.sun[1].meanHours, lawn.sun[0].meanHours, 0.02);
}

TEST(SunByPlace, DatesStateTheShareWithTooLittle) {
    SunByPlaceSettings settings = ofDays(3);
    settings.dates = {std::chrono::year(2026) / 12 / 21, std::chrono::year(2026) / 6 / 21};
    settings.enoughHours = 5;
    const SunByPlace sun = measured(tower(), {namedPlace("Park", 0, 20, 20, 60)}, settings);
    ASSERT_EQ(sun.sun[0].belowShare.size(), 2U);
    EXPECT_GT(sun.sun[0].belowShare[0], 0.1) << "behind the tower in winter";
    EXPECT_LT(sun.sun[0].belowShare[1], sun.sun[0].belowShare[0]);
}

TEST(SunByPlace, ADayWithoutSunLeavesNothingWithEnough) {
    City city;
    city.frame = Frame({18.95, 69.65});  // Tromso
    SunByPlaceSettings settings = ofDays(3);
    settings.study.period.zone = "Europe/Oslo";
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const SunByPlace sun = measured(city, {namedPlace("Square", 0, 0, 20, 20)}, settings);
    EXPECT_EQ(sun.sun[0].belowShare, std::vector<double>{1.0});
}

TEST(SunByPlace, APlaceBelowABuildingIsListedAndNotDropped) {
    const SunByPlace sun =
        measured(tower(), {namedPlace("Inside", 4, 4, 16, 16), namedPlace("Park", 0, 20, 20, 60)}, ofDays(3));
    ASSERT_EQ(sun.sun.size(), 2U);
    EXPECT_EQ(sun.sun[0].areaM2, 0);
    EXPECT_TRUE(std::isnan(sun.sun[0].meanHours));
    ASSERT_FALSE(sun.warnings.empty());
    EXPECT_EQ(sun.warnings.back().where, "Inside");
    EXPECT_EQ(sun.sun[0].why, NoSunFigures::builtOver);
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
    SunByPlaceSettings settings = ofDays(3);
    settings.smallCellM = 2;
    const SunByPlace sun = measured(
        tower(), {namedPlace("Park", -30, 20, 50, 60), namedPlace("Inside", 4, 4, 16, 16)}, settings);
    expectListed(sun, 1, "buildings stand on all of it", "built_over");
    EXPECT_THAT(listRemarks(sun.sun[0]), IsEmpty());
}

// The terrain ends 100 m east of the tower.
TEST(SunByPlace, APlaceBeyondTheTerrainIsListedAndMeasured) {
    City city = tower();
    city.terrain =
        std::make_shared<const Terrain>(Terrain{{-1100, -1100, 60, 20, 20}, std::vector<float>(400, 0)});
    const SunByPlace sun =
        measured(city, {namedPlace("Park", -30, 20, 50, 60), namedPlace("Far", 150, 0, 190, 40)}, ofDays(3));
    expectListed(sun, 1, "beyond the terrain: the nearest elevation is taken", "beyond_terrain");
    EXPECT_THAT(listRemarks(sun.sun[0]), IsEmpty());
    EXPECT_GT(sun.sun[1].meanHours, 0);
}

TEST(SunByPlace, APlaceOnWaterIsListedAndMeasured) {
    City city = tower();
    MapContext map;
    map.areas = {{ContextKind::water, "Lake", {{rectangle(100, 0, 160, 40), {}}}}};
    city.context = std::make_shared<const MapContext>(std::move(map));
    const SunByPlace sun =
        measured(city, {namedPlace("Park", -30, 20, 50, 60), namedPlace("Lake", 100, 0, 160, 40)}, ofDays(3));
    expectListed(sun, 1, "mostly on water: measured at its surface", "on_water");
    EXPECT_THAT(listRemarks(sun.sun[0]), IsEmpty());
    EXPECT_GT(sun.sun[1].meanHours, 0);
}

TEST(SunByPlace, AZoneFarFromThePlacesIsQuestioned) {
    SunByPlaceSettings far = ofDays(3);
    far.study.period.zone = "Asia/Tokyo";
    far.study.period.window.reset();
    far.study.period.from = std::chrono::hours(23);  // 9 in New York
    EXPECT_THAT(measured(tower(), {namedPlace("Park", 0, 20, 20, 60)}, far).warnings, Not(IsEmpty()));
    EXPECT_THAT(measured(tower(), {namedPlace("Park", 0, 20, 20, 60)}, ofDays(3)).warnings, IsEmpty());
}

// Winter's days are those of February, spring's those of March; south of the equator they swap names.
TEST(SunByPlace, SeasonsAreNamedByTheirMonths) {
    const SunByPlace sun = measured(tower(), {namedPlace("Park", -30, 20, 50, 60)}, ofDays(20));
    ASSERT_EQ(sun.seasons.size(), 2U);
    EXPECT_EQ(sun.seasons[0].label, "Dec to Feb (winter)");
    EXPECT_EQ(sun.sun[0].seasonHours, sun.sun[0].monthHours);
    City south = tower();
    south.frame = Frame({18.4, -33.9});
    SunByPlaceSettings settings = ofDays(60);
    settings.study.period.start = std::chrono::year(2026) / 1 / 15;
    settings.study.period.zone = "Africa/Johannesburg";
    const SunByPlace cape = measured(south, {namedPlace("Park", -30, 20, 50, 60)}, settings);
    EXPECT_EQ(cape.seasons[0].label, "Dec to Feb (summer)");
    const std::vector<double>& hours = cape.sun[0].monthHours;
    EXPECT_NEAR(cape.sun[0].seasonHours[0], (17 * hours[0] + 28 * hours[1]) / 45, 1e-9);
}

// 6 x 6 m, 9 cells of 2 m: half of it lies in the shadow of a wall that 2 m cannot resolve.
TEST(SunByPlace, SmallPlacesHaveFinerCells) {
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60), namedPlace("Yard", 30, 0, 36, 6)};
    const SunByPlace sun = measured(tower(), places, ofDays(3));
    EXPECT_EQ(sun.sun[0].cellM, 2);
    EXPECT_EQ(sun.sun[1].cellM, 0.5);
    EXPECT_EQ(sun.sun[1].cells, 144U);
    EXPECT_DOUBLE_EQ(sun.sun[1].areaM2, 36);
    const SunByPlace fine = measured(tower(), {places[1]}, ofDays(3, 0.5));
    EXPECT_NEAR(sun.sun[1].meanHours, fine.sun[0].meanHours, 0.01);
    SunByPlaceSettings asTheOthers = ofDays(3);
    asTheOthers.smallCellM = 2;
    EXPECT_EQ(measured(tower(), places, asTheOthers).sun[1].cells, 9U);
}

TEST(SunByPlace, EachDateHasItsOwnError) {
    SunByPlaceSettings settings = ofDays(3);
    settings.study.engine = "horizon";
    settings.dates = {std::chrono::year(2026) / 12 / 21, std::chrono::year(2026) / 6 / 21};
    const SunByPlace sun = measured(tower(), {namedPlace("Park", -30, 20, 50, 60)}, settings);
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
    SunByPlaceSettings settings = ofDays(20);
    settings.smallCellM = 2;
    settings.study.engine = "horizon";
    settings.study.engineSettings["bin"] = 2;
    const SunByPlace sun = measured(tower(), {corner}, settings);
    StudySettings byRays = ofDays(20).study;
    byRays.region = {"Corner", corner.polygons};
    byRays.engine = "ray";
    NoProgress quiet;
    const auto rays = runStudy(tower(), byRays, quiet, {});
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

TEST(SunByPlace, PiecesWithoutANameAreFoldedUnderTheirPark) {
    const auto unnamed = [](float west, float south, float east, float north) {
        Place place = namedPlace("", west, south, east, north, PlaceKind::greenstreet);
        place.source = "OSM way 1";
        place.name = "greenstreet (OSM way 1)";
        return place;
    };
    const SunByPlace sun =
        measured(tower(),
                 {namedPlace("Park", -30, 20, 50, 60), unnamed(0, 30, 20, 40), unnamed(50.5F, 20, 60, 60),
                  unnamed(70, 20, 80, 60), namedPlace("Lawn", 0, 40, 20, 50),
                  namedPlace("Road", 60, 20, 70, 60, PlaceKind::street)},
                 ofDays(3));
    using Whole = std::optional<std::size_t>;
    EXPECT_EQ(sun.partOf, (std::vector<Whole>{{}, 0, 0, {}, {}, {}}));
}

// A wall 60 m high along the south of the park, in one city alone.
City withWall(const City& city) {
    City changed = city;
    changed.buildings.push_back(buildingOf(Box3{{-30, 15, 0}, {50, 18, 60}}));
    return changed;
}

SunOfCities compared(const std::vector<NamedCity>& cities, const std::vector<Place>& places,
                     const SunByPlaceSettings& settings) {
    NoProgress quiet;
    auto sun = compareSunByPlace(cities, places, settings, quiet, {});
    EXPECT_TRUE(sun) << (sun ? "" : sun.error().text());
    return sun ? *std::move(sun) : SunOfCities{};
}

// The park lies north of the wall, the far place where nothing of it can be seen.
class SunByPlaceBy : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Engines, SunByPlaceBy, testing::Values("horizon", "projected"));

TEST_P(SunByPlaceBy, ChangesEqualThoseOfCitiesMeasuredApart) {
    SunByPlaceSettings settings = ofDays(3);
    settings.study.engine = GetParam();
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60),
                                    namedPlace("Far", -400, -400, -360, -360)};
    const SunOfCities both = compared({{"Now", tower()}, {"Wall", withWall(tower())}}, places, settings);
    const SunByPlace alone = measured(withWall(tower()), places, settings);
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
    SunByPlaceSettings settings = ofDays(3);
    settings.study.engine = "horizon";
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60),
                                    namedPlace("Far", -400, -400, -360, -360)};
    const SunOfCities both = compared({{"Now", tower()}, {"Wall", withWall(tower())}}, places, settings);
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
    EXPECT_THAT(measured(tower(), places, settings).errors, IsEmpty());
}

// Of 9 m2, with 36 cells of 0.5 m.
TEST(SunByPlace, PlacesWithSmallCellsHaveAnErrorOfTheirOwn) {
    SunByPlaceSettings settings = ofDays(3);
    settings.study.engine = "horizon";
    settings.study.engineSettings["bin"] = 2;
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60), namedPlace("Corner", 4, 22, 7, 25)};
    const SunByPlace sun = measured(tower(), places, settings);
    ASSERT_EQ(sun.sun[1].cellM, 0.5);
    const ShownError* error = findError(sun, "place_small");
    ASSERT_NE(error, nullptr);
    EXPECT_EQ(error->count, 1U) << "there is one small place";
    EXPECT_LT(error->largest, 20);
    settings.smallCellM = 2;
    EXPECT_EQ(findError(measured(tower(), places, settings), "place_small"), nullptr);
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
    SunByPlaceSettings settings = ofDays(3);
    settings.study.engine = GetParam();
    settings.dates = {std::chrono::year(2026) / 12 / 21, std::chrono::year(2026) / 6 / 21};
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60), namedPlace("Small", 22, 22, 27, 27),
                                    namedPlace("Far", -2000, -400, -1995, -395)};
    const NamedCity cities[]{{"Now", tower()}, {"Wall", withWall(tower())}, {"Same", tower()}};
    RisingOnly progress;
    ASSERT_TRUE(compareSunByPlace(cities, places, settings, progress, {}));
    EXPECT_FALSE(progress.fell());
    EXPECT_GT(progress.last(), 0.9);
    EXPECT_LE(progress.last(), 1);
}

TEST(SunByPlace, PlacesThatChangeStandSideBySideAboveTheirChanges) {
    const std::vector<Place> places{namedPlace("Far", -400, -400, -360, -360),
                                    namedPlace("Park", -30, 20, 50, 60)};
    const SunOfCities all =
        compared({{"Now", tower()}, {"Wall", withWall(tower())}, {"Same", tower()}}, places, ofDays(3));
    const AnswerPage page = makePage(all);
    ASSERT_EQ(page.charts.size(), 4U) << "months and places, each above what changes";
    const Bars &hours = page.charts[2], &changes = page.charts[3];
    EXPECT_EQ(hours.series, (std::vector<std::string>{"Now", "Wall", "Same"}));
    ASSERT_EQ(hours.groups.size(), 1U) << "nothing changes in the far place";
    EXPECT_EQ(groupKey(hours.groups[0]), "Park");
    EXPECT_DOUBLE_EQ(hours.groups[0].values[0], all.baseline.sun[1].meanHours);
    EXPECT_TRUE(changes.isChange);
    EXPECT_NEAR(changes.groups[0].values[0], 60 * all.compared[0].changes[1].meanHours, 1e-9) << "minutes";
    EXPECT_EQ(changes.groups[0].values[1], 0);
    EXPECT_EQ(makePage({all.baseline, {}}).charts.size(), 1U) << "of one city, its months alone";
}

TEST(SunByPlace, PlacesWithoutANameAreNotChartedBesideThoseWithOne) {
    Place unnamed = namedPlace("park (OSM way 7)", -30, 20, 10, 60);
    unnamed.source = "OSM way 7";
    const auto charted = [](const std::vector<Place>& places) {
        std::vector<std::string> names;
        const AnswerPage page =
            makePage(compared({{"Now", tower()}, {"Wall", withWall(tower())}}, places, ofDays(3)));
        for (const Bars::Group& group : page.charts[2].groups) names.push_back(groupKey(group));
        return names;
    };
    EXPECT_EQ(charted({unnamed, namedPlace("Park", 10, 20, 50, 60)}), std::vector<std::string>{"Park"});
    EXPECT_EQ(charted({unnamed}), std::vector<std::string>{"park (OSM way 7)"}) << "rather than nothing";
}

TEST(SunByPlace, OneSentenceJudgesWhichCityTakesLessSun) {
    const SunOfCities all = compared({{"Now", tower()}, {"Wall", withWall(tower())}, {"Same", tower()}},
                                     {namedPlace("Park", -30, 20, 50, 60)}, ofDays(3));
    const AnswerPage page = makePage(all);
    ASSERT_GE(page.findings.size(), 2U);
    const std::string verdict = formatText(page.findings[1]);
    EXPECT_THAT(verdict, testing::StartsWith("Same takes less sun than Wall: 0 min against "));
}

TEST(SunByPlace, SentencesCountPlacesOnDatesAndNameTheDarkestAndTheSunniest) {
    const std::vector<Place> places{namedPlace("Far", -400, -400, -360, -360),
                                    namedPlace("Park", -30, 20, 50, 60)};
    SunByPlaceSettings settings = ofDays(3);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    settings.enoughHours = 0.5;
    const SunByPlace sun = measured(tower(), places, settings);
    std::vector<std::string> findings;
    for (const Sentence& finding : makePage({sun, {}}).findings) findings.push_back(formatText(finding));
    EXPECT_THAT(findings, testing::Contains("On 2026-12-21, 0 of 2 places have less than 0.5 h."));
    EXPECT_THAT(findings,
                testing::Contains(testing::AllOf(testing::StartsWith("Park has the least sun, "),
                                                 testing::HasSubstr(" h a day, and Far the most, "))));
}

TEST(SunByPlace, AnotherThresholdGivesTheSharesOfARunWithIt) {
    const std::vector<Place> places{namedPlace("Park", -30, 20, 50, 60)};
    SunByPlaceSettings settings = ofDays(3);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    settings.enoughHours = 2;
    const SunOfCities asked{measured(tower(), places, settings), {}};
    for (const double hours : {0.0, 1.5, 4.1, 6.0, 9.0}) {
        settings.enoughHours = hours;
        const SunByPlace again = measured(tower(), places, settings);
        const auto restated = withEnough(asked, hours);
        ASSERT_TRUE(restated);
        EXPECT_EQ(restated->baseline.settings.enoughHours, hours);
        EXPECT_NEAR(restated->baseline.sun[0].enoughShare, again.sun[0].enoughShare, 1e-6) << hours;
        EXPECT_NEAR(restated->baseline.sun[0].belowShare[0], again.sun[0].belowShare[0], 1e-6) << hours;
        EXPECT_TRUE(haveSameShadow(asked, *restated));
    }
    SunOfCities saved = asked;
    for (SunOfPlace& of : saved.baseline.sun) of.ofCells.clear();
    EXPECT_FALSE(withEnough(saved, 3)) << "its cells are not known";
}

TEST(SunByPlace, TheSentencesOfOnePlaceStateItsSunItsDatesAndWhatIsTaken) {
    SunByPlaceSettings settings = ofDays(3);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const SunOfCities both =
        compared({{"Now", tower()}, {"Wall", withWall(tower())}},
                 {namedPlace("Park", -30, 20, 50, 60), namedPlace("Far", -400, -400, -360, -360)}, settings);
    const AnswerPage page = makePage(both, 0);
    EXPECT_THAT(formatText(page.headline), testing::StartsWith("Park: "));
    ASSERT_EQ(page.findings.size(), 2U);
    EXPECT_THAT(formatText(page.findings[0]), testing::StartsWith("Wall takes "));
    EXPECT_THAT(formatText(page.findings[1]), testing::StartsWith("On 2026-12-21 it has "));
    ASSERT_EQ(page.charts.size(), 2U);
    EXPECT_DOUBLE_EQ(page.charts[0].groups[0].values[0], both.baseline.sun[0].monthHours[0]);
    EXPECT_NE(makePage(both, 1).charts[0].groups[0].values[0], page.charts[0].groups[0].values[0]);
}

// A building of the scenario stands on a fifth of the park: that ground counts in neither city.
TEST(SunByPlace, CitiesAreComparedOnGroundThatIsOpenInAllOfThem) {
    City built = tower();
    built.buildings.push_back(buildingOf(Box3{{34, 20, 0}, {50, 60, 3}}));
    const SunOfCities both =
        compared({{"Now", tower()}, {"Built", built}}, {namedPlace("Park", -30, 20, 50, 60)}, ofDays(3));
    EXPECT_DOUBLE_EQ(both.baseline.sun[0].areaM2, 64 * 40);
    EXPECT_DOUBLE_EQ(both.compared[0].sun.sun[0].areaM2, 64 * 40);
}

TEST(SunByPlace, ColumnsNameTheScenarios) {
    const SunOfCities all =
        compared({{"Now", tower()}, {"Tower B!", withWall(tower())}, {"tower b?", tower()}},
                 {namedPlace("Park", -30, 20, 50, 60)}, ofDays(3));
    const std::string csv = toCsv(makeTable(all.baseline, all.compared));
    EXPECT_THAT(csv, HasSubstr("hours_mean_tower_b,"));
    EXPECT_THAT(csv, HasSubstr("change_hours_tower_b,max_loss_min_tower_b,max_gain_min_tower_b,"
                               "share_lost_tower_b,hours_mean_tower_b_2,"));
    const auto json = nlohmann::json::parse(toJson(all.baseline, all.compared));
    EXPECT_NEAR(json["places"][0]["scenarios"]["Tower B!"]["change_hours"].get<double>(),
                all.compared[0].changes[0].meanHours, 1e-4);
    EXPECT_EQ(json["scenarios"][1]["name"], "tower b?");
    EXPECT_TRUE(json["definitions"].contains("change_hours"));
}

TEST(SunByPlace, RefusesWhatItCannotMeasure) {
    EXPECT_THAT(refusal({}, ofDays(3)), HasSubstr("no place"));
    SunByPlaceSettings tooMuch = ofDays(3);
    tooMuch.enoughHours = 25;
    EXPECT_THAT(refusal({namedPlace("Park", 0, 20, 20, 60)}, tooMuch), HasSubstr("0 to 24"));
    SunByPlaceSettings rays = ofDays(3);
    rays.study.engine = "ray";
    EXPECT_THAT(refusal({namedPlace("Park", 0, 20, 20, 60)}, rays), HasSubstr("sums no months"));
    EXPECT_THAT(refusal({namedPlace("Inside", 4, 4, 16, 16)}, ofDays(3)), HasSubstr("open ground"));
}

TEST(SunByPlace, TableJsonAndGeoPackageSayTheSame) {
    SunByPlaceSettings settings = ofDays(20);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const SunByPlace sun = measured(
        tower(),
        {namedPlace("Park", -30, 20, 50, 60), namedPlace("A, \"B\"", 0, 20, 20, 60, PlaceKind::plaza)},
        settings);
    const ElementTable table = makeTable(sun);
    const std::string csv = toCsv(table);
    EXPECT_THAT(csv,
                HasSubstr("name,kind,part_of,area_m2,hours_mean,hours_min,hours_max,share_enough,"
                          "hours_dec_feb,hours_mar_may,hours_2026-02,hours_2026-03,hours_2026-12-21,"
                          "share_below_2026-12-21,cell_m,without_figures,remarks,lon_deg,lat_deg,source"));
    EXPECT_THAT(csv, HasSubstr("\"A, \"\"B\"\"\",plaza,,800.00,"));
    const auto json = nlohmann::json::parse(toJson(sun));
    EXPECT_NEAR(json["places"][1]["hours_mean"].get<double>(), sun.sun[1].meanHours, 1e-4);
    EXPECT_EQ(json["places"][0]["month_hours"].size(), 2U);
    EXPECT_TRUE(json["error"].is_object());

    const tests::TemporaryFolder folder;
    const auto file = folder.path("places.gpkg");
    ASSERT_TRUE(writePlacesGeoPackage(file, sun.city.frame, sun.places, table, makeStyle(sun)));
    NoProgress quiet;
    const auto read = readPlaces(file, {}, sun.city.frame, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->places.size(), 2U);
    EXPECT_EQ(read->places[1].name, "A, \"B\"");
    EXPECT_EQ(read->places[1].kind, PlaceKind::plaza);
    EXPECT_NEAR(area(read->places[0]), 3200, 1);
}

// A column of the table in JSON: hours of parts of the period stand in objects of their own there.
std::optional<double> numberOf(const nlohmann::json& place, const std::string& column) {
    if (place.contains(column) && place[column].is_number()) return place[column].get<double>();
    for (const auto& [object, prefix] :
         {std::pair("season_hours", "hours_"), std::pair("month_hours", "hours_"),
          std::pair("date_hours", "hours_"), std::pair("share_below", "share_below_")})
        if (column.starts_with(prefix)) {
            const std::string key = column.substr(std::string_view(prefix).size());
            if (place.contains(object) && place[object].contains(key))
                return place[object][key].get<double>();
        }
    return std::nullopt;
}

// The numbers of all files come from one table: what CSV rounds, the GeoPackage holds, and JSON rounds alike.
TEST(SunByPlace, TheCsvIsTheGeoPackageRoundedAndJsonAgrees) {
    SunByPlaceSettings settings = ofDays(20);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const SunByPlace sun = measured(
        tower(), {namedPlace("North", -30, 20, 50, 60), namedPlace("East", 24, -10, 61, 15)}, settings);
    const ElementTable table = makeTable(sun);
    const TemporaryFolder folder;
    const auto file = folder.path("places.gpkg");
    ASSERT_TRUE(writePlacesGeoPackage(file, sun.city.frame, sun.places, table, makeStyle(sun)));
    const GdalCalls calls;
    const GDALDatasetUniquePtr read(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR));
    ASSERT_TRUE(read);
    OGRLayer* places = read->GetLayerByName("places");
    ASSERT_NE(places, nullptr);
    const std::string csv = toCsv(table);
    const auto json = nlohmann::json::parse(toJson(sun));
    std::size_t compared = 0, inJson = 0;
    for (std::size_t row = 0; row < 2; ++row) {
        const OGRFeatureUniquePtr feature(places->GetNextFeature());
        ASSERT_TRUE(feature);
        std::string line;
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            const ElementColumn& column = table.columns[i];
            const int field = feature->GetFieldIndex(column.name.c_str());
            ASSERT_GE(field, 0) << column.name;
            line += i == 0 ? "\n" : ",";
            if (!std::holds_alternative<double>(column.kind)) {
                line += feature->GetFieldAsString(field);
                continue;
            }
            const std::size_t begins = line.size();
            line += fmt::format("{:.{}f}", feature->GetFieldAsDouble(field), column.decimals);
            ++compared;
            if (const auto number = numberOf(json["places"][row], column.name)) {
                EXPECT_EQ(fmt::format("{}", *number), fmt::format("{}", std::stod(line.substr(begins))))
                    << column.name << ": to the last digit";
                ++inJson;
            }
        }
        EXPECT_THAT(csv, HasSubstr(line)) << "a row of the CSV, made from the GeoPackage";
    }
    EXPECT_GT(compared, 20U);
    EXPECT_GE(inJson, 2 * (5U + 2 + 2 + 2)) << "figures, seasons, months, hours and share of the date";
}

TEST(SunByPlace, StyleHasTheClassesAroundEnoughSunInTheColoursOfTheLegend) {
    SunByPlace sun;
    sun.settings.enoughHours = 3;
    sun.sun.resize(2);
    sun.sun[0].meanHours = 8.5;
    const std::string qml = makeStyle(sun).qml;
    EXPECT_THAT(qml, HasSubstr(R"(attr="hours_mean")"));
    EXPECT_THAT(qml, HasSubstr(R"(lower="2" upper="3" symbol="2")"));
    EXPECT_THAT(qml, HasSubstr(R"(lower="3" upper="5" symbol="3" label="3 to 5 h")"));
    EXPECT_THAT(qml, HasSubstr(R"(<symbol type="fill" name="5")"));
    EXPECT_THAT(makeStyle(sun, {{}, 6.0}).qml, HasSubstr(R"(lower="6" upper=")"));
    EXPECT_NE(makeStyle(sun, {{.ramp = Ramp::viridis}, {}}).qml, qml);
}

TEST(SunByPlace, OtherStylesColourByTheHoursOfDatesSeasonsAndMonths) {
    SunByPlaceSettings settings = ofDays(20);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    const SunByPlace sun = measured(tower(), {namedPlace("Park", -30, 20, 50, 60)}, settings);
    const std::vector<LayerStyle> others = makeStyle(sun).others;
    std::vector<std::string> columns;
    for (const ElementColumn& column : makeTable(sun).columns) columns.push_back(column.name);
    ASSERT_EQ(others.size(), 1U + 2 + 2) << "winter and spring, February and March";
    for (const LayerStyle& one : others) {
        const std::size_t first = one.qml.find("attr=\"") + 6, end = one.qml.find('"', first);
        EXPECT_THAT(columns, testing::Contains(one.qml.substr(first, end - first))) << one.name;
    }
    EXPECT_EQ(others.front().name, "Hours of sun a day, 2026-12-21");
}

TEST(SunByPlace, TheCommandNamesPlacesScenariosAndSettings) {
    SunByPlace sun;
    EXPECT_FALSE(makeRepeatCommand(sun));
    sun.name = "Existing";
    sun.asked = PlacesAsked{{{"--kind", {"park"}}}, true};
    sun.settings = ofDays(3);
    sun.settings.enoughHours = 3;
    sun.settings.dates = {std::chrono::year(2026) / 12 / 21};
    sun.provenance.project = ProjectRecord{"town.noonmark.gpkg", "hash", {}, {}, {}};
    std::vector<ComparedSun> compared(1);
    compared[0].sun.name = "Lower tower";
    const auto command = makeRepeatCommand(sun, compared, 1000);
    ASSERT_TRUE(command) << command.error().text();
    EXPECT_THAT(*command, HasSubstr("noonmark-cli by-place town.noonmark.gpkg "));
    EXPECT_THAT(*command, HasSubstr("--baseline Existing --scenario 'Lower tower' --kind park"));
    EXPECT_THAT(*command, HasSubstr("--enough 3 --date 2026-12-21"));
    EXPECT_THAT(*command, Not(HasSubstr("--region")));
    EXPECT_THAT(*command, Not(HasSubstr("--by month")));
}

}  // namespace
}  // namespace noonmark
