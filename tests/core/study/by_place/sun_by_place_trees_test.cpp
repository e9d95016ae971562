#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/csv_text.h"
#include "core/city/trees/tree.h"
#include "core/io/places/read_places.h"
#include "core/study/by_place/place_tables.h"
#include "core/study/elements/element_tables.h"
#include "core/study/tiles/by_place_measure.h"
#include "tests/core/study/by_place/place_scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

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
    SunByPlaceSettings settings = settingsOfDays(20);
    settings.dates = {std::chrono::year(2026) / 7 / 1, std::chrono::year(2026) / 12 / 21};
    settings.enoughHours = 4;
    const SunByPlace sun = measureByPlace(underLeaves(), {namedPlace("Street", -10, -10, 10, 10)}, settings);
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

TEST(SunInColumn, StatesTheSunWithTreesInPlaceOfThatWithout) {
    SunByPlaceSettings settings = settingsOfDays(5);
    settings.dates = {std::chrono::year(2026) / 12 / 21};
    SunOfCities sun;
    sun.baseline = measureByPlace(underLeaves(), {namedPlace("Street", -10, -10, 10, 10)}, settings);
    EXPECT_EQ(listSunColumns(sun),
              (std::vector{TreeColumns::without, TreeColumns::evergreen, TreeColumns::seasonal}));
    EXPECT_FALSE(inColumn(sun, TreeColumns::without));
    const auto shaded = inColumn(sun, TreeColumns::seasonal);
    ASSERT_TRUE(shaded);
    EXPECT_EQ(shaded->baseline.sun[0].meanHours, sun.baseline.withTrees[1].sun[0].meanHours);
    EXPECT_EQ(shaded->baseline.sun[0].dateHours, sun.baseline.withTrees[1].sun[0].dateHours);
    EXPECT_EQ(listSunColumns(*shaded), std::vector{TreeColumns::without});
    const auto errorsOf = [](const SunByPlace& all, std::string_view of) {
        return std::ranges::count_if(all.errors, [&](const ShownError& error) {
            return error.facts.key == "place_mean" && error.of == of;
        });
    };
    EXPECT_EQ(errorsOf(sun.baseline, "trees with their seasons"), 1);
    EXPECT_EQ(errorsOf(shaded->baseline, ""), 1);
    EXPECT_EQ(errorsOf(shaded->baseline, "trees with their seasons"), 0);
}

City avenue() {
    City city = loneTower();
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
    SunByPlaceSettings settings = settingsOfDays(20);
    settings.study.engine = "horizon";
    const SunByPlace sun = measureByPlace(avenue(), {park}, settings);
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
    const SunByPlace bare = measureByPlace(loneTower(), {park}, settingsOfDays(3));
    City far = loneTower();
    far.trees = std::make_shared<const Trees>(Trees{{{.place = {90'000, 0}}}, {100, 300}});
    const SunByPlace sun = measureByPlace(far, {park}, settingsOfDays(3));
    EXPECT_TRUE(sun.withTrees.empty());
    EXPECT_EQ(toCsv(makeTable(sun)), toCsv(makeTable(bare)));
    const SunByPlace with = measureByPlace(avenue(), {park}, settingsOfDays(3));
    EXPECT_THAT(with.field.grossMin, testing::Pointwise(testing::NanSensitiveFloatEq(), bare.field.grossMin));
    SunByPlaceSettings without = settingsOfDays(3);
    without.study.trees = TreeColumns::without;
    EXPECT_TRUE(measureByPlace(avenue(), {park}, without).withTrees.empty());
}

// Three days and the first of them alone; a baseline without trees, and a scenario that plants an avenue.
SunOfCities plantAvenue() {
    SunByPlaceSettings settings = settingsOfDays(3);
    settings.lossMin = 30;
    settings.dates = {settings.study.period.start};
    return compareByPlace({{"Before", loneTower()}, {"Avenue", avenue()}},
                          {namedPlace("Park", -30, 20, 50, 60)}, settings);
}

TEST(SunByPlace, PlantingAnAvenueTakesSunOnlyWithTrees) {
    const SunOfCities all = plantAvenue();
    ASSERT_EQ(all.compared.size(), 1U);
    const ComparedSun& planted = all.compared[0];
    EXPECT_EQ(planted.changes[0].meanHours, 0);
    ASSERT_EQ(planted.changesWithTrees.size(), 2U);
    const SunChange &evergreen = planted.changesWithTrees[0][0], &seasonal = planted.changesWithTrees[1][0];
    EXPECT_EQ(all.baseline.withTrees[0].sun[0].meanHours, all.baseline.sun[0].meanHours);
    EXPECT_LT(evergreen.meanHours, seasonal.meanHours);
    EXPECT_LT(seasonal.meanHours, -0.1);
    EXPECT_GT(evergreen.lostShare, 0.05);
    std::vector<std::string> findings;
    for (const Sentence& finding : makePage(all, ShownAs::sun).findings)
        findings.push_back(formatText(finding));
    EXPECT_THAT(findings,
                testing::Contains(HasSubstr("Avenue takes more than a minute of sun a day from 0 places")));
    EXPECT_THAT(findings, testing::Contains(
                              HasSubstr("With trees that lose their leaves by season their number is 1")));
    const std::string csv = toCsv(makeTable(all.baseline, all.compared));
    EXPECT_THAT(csv, HasSubstr("change_hours_evergreen_avenue"));
    const auto json = nlohmann::json::parse(toJson(all.baseline, all.compared));
    EXPECT_NEAR(json["places"][0]["scenarios"]["Avenue"]["change_hours_seasonal"].get<double>(),
                seasonal.meanHours, 1e-4);
    const SunOfCities less = withEnough(all, 1).value();
    EXPECT_EQ(less.compared[0].sun.withTrees[0].sun[0].enoughShare,
              computeEnoughShare(planted.sun.withTrees[0].sun[0], 1));
}

// A spreadsheet gets cities, trees and months as values of rows: columns that can be seen at once.
TEST(SunByPlace, TablesForSpreadsheetsHaveTheSameColumnsWhateverIsAsked) {
    const SunOfCities all = plantAvenue();
    const auto tableOf = [&](std::size_t i) {
        return parseCsvRows(toCsv(placeTables()[i].make(all.baseline, all.compared)));
    };
    const auto period = tableOf(0), parts = tableOf(1);
    EXPECT_THAT(period[0].fields,
                testing::ElementsAre("name", "kind", "part_of", "scenario", "trees", "area_m2", "hours_mean",
                                     "hours_min", "hours_max", "share_enough", "shadow_mean_min",
                                     "shadow_most_min", "shadow_least_min", "change_hours", "max_loss_min",
                                     "max_gain_min", "share_lost", "change_shadow_min", "cell_m",
                                     "without_figures", "remarks", "lon_deg", "lat_deg", "source"));
    ASSERT_EQ(period.size(), 1 + 2 * 3U) << "two cities, trees counted in three ways";
    EXPECT_THAT(std::vector<std::string>(period[6].fields.begin(), period[6].fields.begin() + 5),
                testing::ElementsAre("Park", "park", "", "Avenue", "seasonal"));
    EXPECT_NEAR(std::stod(period[6].fields[6]), all.compared[0].sun.withTrees[1].sun[0].meanHours, 1e-4);
    EXPECT_NEAR(std::stod(period[6].fields[13]), all.compared[0].changesWithTrees[1][0].meanHours, 1e-4);
    EXPECT_NEAR(std::stod(period[6].fields[17]), -60 * all.compared[0].changesWithTrees[1][0].meanHours,
                0.01);
    EXPECT_EQ(period[1].fields[13], "") << "the baseline is not compared with itself";

    EXPECT_THAT(parts[0].fields,
                testing::ElementsAre("name", "kind", "part_of", "scenario", "trees", "time", "time_kind",
                                     "hours_mean", "shadow_mean_min", "share_below", "change_hours"));
    ASSERT_EQ(parts.size(), 1 + 6 * listParts(all.baseline).size());
    EXPECT_EQ(parts.back().fields[5], formatText(all.baseline.settings.dates[0]));
    EXPECT_EQ(parts.back().fields[6], "date");
    EXPECT_NEAR(std::stod(parts.back().fields[7]), all.compared[0].sun.withTrees[1].sun[0].dateHours[0],
                1e-4);
    EXPECT_NEAR(std::stod(parts.back().fields[10]),
                std::stod(parts.back().fields[7]) - all.baseline.withTrees[1].sun[0].dateHours[0], 2e-4);

    const SunByPlace plain =
        measureByPlace(loneTower(), {namedPlace("Park", -30, 20, 50, 60)}, settingsOfDays(3));
    const auto plainRows = [&](std::size_t i) {
        return parseCsvRows(toCsv(placeTables()[i].make(plain, {})));
    };
    std::vector<std::string> withoutChange = period[0].fields;
    withoutChange.erase(withoutChange.begin() + 13, withoutChange.begin() + 18);
    EXPECT_EQ(withoutChange.size(), 19U);
    EXPECT_EQ(plainRows(0)[0].fields, withoutChange) << "without scenario and trees";
    EXPECT_EQ(plainRows(0).size(), 2U);
    EXPECT_EQ(plainRows(1)[0].fields,
              std::vector<std::string>(parts[0].fields.begin(), parts[0].fields.end() - 1));
}

std::vector<std::string> rowsOfScenario(const SunOfCities& all, const PlaceTable& table) {
    std::vector<std::string> rows;
    for (const CsvRow& row : parseCsvRows(toCsv(table.make(all.baseline, all.compared))))
        if (row.fields[3] == "Avenue") rows.push_back(fmt::format("{}", fmt::join(row.fields, ";")));
    return rows;
}

// Columns belong together by what they count, wherever they stand: a baseline that lacks one has no tree that
// reaches a place, and with trees what it has without.
TEST(SunByPlace, ABaselineWithoutColumnsOfTreesHasInThemItsSunWithout) {
    const SunOfCities all = plantAvenue();
    EXPECT_NE(all.baseline.treesHow, "") << "it has columns, though no trees of its own";
    SunOfCities bare = all;
    bare.baseline.withTrees.clear();
    EXPECT_EQ(listSunColumns(bare), listSunColumns(all));
    const auto changes = computeChangesWithTrees(bare.baseline, bare.compared[0].sun);
    ASSERT_EQ(changes.size(), 2U);
    for (std::size_t column = 0; column < 2; ++column)
        EXPECT_EQ(changes[column][0].maxLossMin, all.compared[0].changesWithTrees[column][0].maxLossMin);
    for (const PlaceTable& table : placeTables()) {
        EXPECT_EQ(rowsOfScenario(bare, table), rowsOfScenario(all, table)) << table.file;
        EXPECT_FALSE(rowsOfScenario(bare, table).empty());
    }
    const auto json = nlohmann::json::parse(toJson(bare.baseline, bare.compared)),
               whole = nlohmann::json::parse(toJson(all.baseline, all.compared));
    EXPECT_EQ(json["places"][0]["scenarios"], whole["places"][0]["scenarios"]);
    EXPECT_EQ(json["definitions"], whole["definitions"]);
    EXPECT_EQ(json["engine_trees"], whole["engine_trees"]);
    EXPECT_THAT(toCsv(makeTable(bare.baseline, bare.compared)),
                HasSubstr("change_hours_2026-02_seasonal_avenue"));

    const auto shown = inColumn(bare, TreeColumns::seasonal);
    ASSERT_TRUE(shown);
    EXPECT_EQ(shown->baseline.sun[0].meanHours, all.baseline.sun[0].meanHours);
    EXPECT_EQ(shown->compared[0].sun.sun[0].meanHours, all.compared[0].sun.withTrees[1].sun[0].meanHours);
    EXPECT_EQ(shown->compared[0].changes[0].meanHours, all.compared[0].changesWithTrees[1][0].meanHours);

    const auto lineOf = [](const SunOfCities& of) {
        const std::string lines = formatLines(of);
        return nlohmann::json::parse(lines.substr(lines.find('\n') + 1));
    };
    ASSERT_EQ(lineOf(bare)["with_trees"].size(), 2U);
    EXPECT_EQ(lineOf(bare)["with_trees"], lineOf(all)["with_trees"]);
}

TEST(SunByPlace, ColumnsInAnotherOrderAreComparedWithTheirLike) {
    const SunOfCities all = plantAvenue();
    SunOfCities turned = all;
    std::ranges::reverse(turned.baseline.withTrees);
    turned.baseline.withTrees[1].sun[0].meanHours = 9;  // evergreen
    const auto changes = computeChangesWithTrees(turned.baseline, turned.compared[0].sun);
    EXPECT_NEAR(changes[0][0].meanHours, all.compared[0].sun.withTrees[0].sun[0].meanHours - 9, 1e-9);
    EXPECT_EQ(changes[1][0].meanHours, all.compared[0].changesWithTrees[1][0].meanHours);
    const auto seasonal = inColumn(turned, TreeColumns::seasonal);
    ASSERT_TRUE(seasonal);
    EXPECT_EQ(seasonal->compared[0].changes[0].meanHours, changes[1][0].meanHours);
}

// Who fells the only trees leaves the scenario none: what it gains stays stated.
TEST(SunInColumn, AScenarioWithoutTheColumnIsSetAgainstTheBaselinesTrees) {
    const SunOfCities planted = plantAvenue();
    SunOfCities felled{planted.compared[0].sun, {{planted.baseline, planted.compared[0].changes, {}}}};
    felled.compared[0].sun.withTrees.clear();
    const auto shown = inColumn(felled, TreeColumns::seasonal);
    ASSERT_TRUE(shown);
    EXPECT_EQ(shown->compared[0].changes[0].meanHours, -planted.compared[0].changesWithTrees[1][0].meanHours);
    EXPECT_EQ(shown->compared[0].changes[0].maxGainMin,
              planted.compared[0].changesWithTrees[1][0].maxLossMin);
}

TEST(ShadowFigures, StandForTheHoursOfSunAndNothingElse) {
    for (const std::span<const Figure> figures :
         {sunOfPlaceFigures().rows(), sunFiguresWithTrees(TreeColumns::evergreen),
          sunFiguresWithTrees(TreeColumns::seasonal)})
        for (const Figure& figure : figures) {
            const ShadowFigure* shadow = findShadow(figure);
            EXPECT_EQ(shadow != nullptr, figure.key.starts_with("hours_")) << figure.key;
            const SunOfPlace of{.meanHours = 1, .minHours = 2, .maxHours = 3};
            if (shadow == nullptr) continue;
            EXPECT_EQ(of.*shadow->hours, figure.get(&of)) << figure.key;
        }
    for (const Figure& figure : sunChangeFigures().rows()) EXPECT_EQ(findShadow(figure), nullptr);
}

// Layers of places are drawn by the column of their table that the legend shows.
TEST(SunInColumn, IsWhatTheStyleOfPlacesIsDrawnBy) {
    const auto sun = std::make_shared<SunOfCities>();
    sun->baseline =
        measureByPlace(underLeaves(), {namedPlace("Street", -10, -10, 10, 10)}, settingsOfDays(5));
    const ElementTable table = makeTable(sun->baseline);
    for (const ShownAs show : {ShownAs::sun, ShownAs::shadow}) {
        PlaceColours colours;
        colours.legend.show = show;
        colours.legend.trees = TreeColumns::seasonal;
        const SunShown shown = showColumn(sun, colours);
        EXPECT_EQ(shown.colours.column, TreeColumns::seasonal);
        EXPECT_EQ(shown.sun->baseline.sun[0].meanHours, sun->baseline.withTrees[1].sun[0].meanHours);
        const std::string qml = makeStyle(shown.sun->baseline, shown.colours).qml;
        const std::size_t at = qml.find("attr=\"") + 6;
        const std::string column = qml.substr(at, qml.find('"', at) - at);
        EXPECT_TRUE(column.ends_with("_seasonal")) << column;
        EXPECT_EQ(std::ranges::count(table.columns, column, &ElementColumn::name), 1) << column;
        colours.legend.trees = TreeColumns::without;
        EXPECT_EQ(showColumn(sun, colours).sun, std::shared_ptr<const SunOfCities>(sun));
        EXPECT_THAT(makeStyle(sun->baseline, showColumn(sun, colours).colours).qml,
                    testing::Not(HasSubstr("_seasonal")));
    }
}

}  // namespace
}  // namespace noonmark
