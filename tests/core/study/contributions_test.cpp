#include "core/study/contributions/place_contributions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/base/progress.h"
#include "core/city/trees/tree.h"
#include "core/receivers/place_names.h"
#include "core/samples/sample_city.h"
#include "core/study/by_place/sun_by_place.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

/// Two equal towers, one behind the other as seen from the south, and open ground north of both.
City twoTowers() {
    City city = cityOf({{{0, 0, 0}, {20, 20, 60}}, {{0, 30, 0}, {20, 50, 60}}});
    city.frame = Frame({-73.98, 40.75});
    return city;
}

/// The same, so wide that the sun passes neither of them on its side.
City wideTowers() {
    City city = cityOf({{{-80, 0, 0}, {100, 20, 60}}, {{-80, 30, 0}, {100, 50, 60}}});
    city.frame = Frame({-73.98, 40.75});
    return city;
}

Place square(const std::string& name, float west, float south, float east, float north) {
    return {name, PlaceKind::park, {{rectangle(west, south, east, north), {}}}, "made up"};
}

/// A day of February around noon, when shadows fall north.
StudySettings atNoon(const std::string& engine) {
    StudySettings settings;
    settings.region = {"Around", {{rectangle(-100, -100, 120, 200), {}}}};
    settings.receivers.cellM = 2;
    settings.engine = engine;
    settings.period = {.start = std::chrono::year(2026) / 2 / 27,
                       .days = 4,
                       .from = std::chrono::hours(11),
                       .hours = 2,
                       .stepMinutes = 5,
                       .zone = "America/New_York"};
    settings.errorSample.receivers = 0;
    return settings;
}

Study studied(const City& city, const StudySettings& settings) {
    NoProgress quiet;
    auto study = runStudy(city, settings, quiet, {});
    EXPECT_TRUE(study) << (study ? "" : study.error().text());
    return *std::move(study);
}

PlaceContributions attributed(const Study& study, const Place& place) {
    NoProgress quiet;
    auto made = computePlaceContributions(study, place, quiet, {});
    EXPECT_TRUE(made) << (made ? "" : made.error().text());
    return *std::move(made);
}

double sumOfRows(const std::vector<Contribution>& rows, double Contribution::*figure) {
    double sum = 0;
    for (const Contribution& row : rows) sum += row.*figure;
    return sum;
}

// Between the towers only the southern one shades.
TEST(PlaceContributions, OneBuildingAloneHasAllOfItAsItsSoleContribution) {
    const PlaceContributions made =
        attributed(studied(twoTowers(), atNoon("horizon")), square("Gap", 6, 22, 14, 28));
    ASSERT_EQ(made.rows.size(), 1U);
    EXPECT_EQ(made.rows[0].building, 0U);
    EXPECT_DOUBLE_EQ(made.rows[0].share, 1);
    EXPECT_GT(made.rows[0].attributedMin, 60);
    EXPECT_DOUBLE_EQ(made.rows[0].soleMin, made.rows[0].attributedMin);
}

// Behind both, the horizon is the nearer tower's: it is charged with all. Without it the other would shade
// the same, so demolition of either gives nothing back.
TEST(PlaceContributions, WhereBothShadeTheNearerIsChargedAndNeitherIsSole) {
    const City city = wideTowers();
    const PlaceContributions made =
        attributed(studied(city, atNoon("horizon")), square("Behind", 6, 52, 14, 56));
    ASSERT_EQ(made.rows.size(), 1U);
    EXPECT_EQ(made.rows[0].building, 1U);
    EXPECT_DOUBLE_EQ(made.rows[0].share, 1);
    EXPECT_NEAR(made.rows[0].attributedMin, 120, 0.01) << "two hours a day, all of them in shadow";
    EXPECT_EQ(made.rows[0].soleMin, 0);
}

TEST(PlaceContributions, APlaceHasTheMinutesOfTheWholeStudyToTheLastDigit) {
    const City city = makeGridSample({.buildings = 200}).value();
    const Box2 box = bounds(city);
    const glm::vec2 middle = (box.low + box.high) * 0.5F;
    StudySettings settings = atNoon("horizon");
    settings.region = {"Middle",
                       {{rectangle(middle.x - 90, middle.y - 90, middle.x + 90, middle.y + 90), {}}}};
    settings.period.days = 60;
    settings.byMonth = settings.contributions = true;
    const Study study = studied(city, settings);
    const Place place = square("Square", middle.x - 33, middle.y - 21, middle.x + 47, middle.y + 39);
    const PlaceContributions made = attributed(study, place);
    ASSERT_GT(made.cells, 100U);
    ASSERT_EQ(made.breakdown.sets.names, study.breakdown->sets.names);
    const Grid &own = made.breakdown.grid, &all = study.field.grid;
    std::vector<std::vector<float>> ofPlace, ofStudy;
    for (std::size_t set = 0; set < made.breakdown.minutes.size(); ++set) {
        ofPlace.push_back(spreadOverGrid(made.breakdown, set));
        ofStudy.push_back(spreadOverGrid(*study.breakdown, set));
    }
    std::size_t compared = 0;
    for (int row = 0; row < own.rows; ++row)
        for (int column = 0; column < own.columns; ++column) {
            const glm::dvec2 at = own.centre(column, row);
            const std::size_t cell =
                all.index(int((at.x - all.westM) / all.cellM), int((at.y - all.southM) / all.cellM));
            for (std::size_t set = 0; set < made.breakdown.minutes.size(); ++set) {
                const float minutes = ofPlace[set][own.index(column, row)];
                if (std::isnan(minutes)) continue;
                ASSERT_EQ(minutes, ofStudy[set][cell]) << column << ' ' << row;
                ++compared;
            }
        }
    EXPECT_EQ(compared, made.cells * made.breakdown.minutes.size());
    EXPECT_NEAR(sumOfRows(made.rows, &Contribution::attributedMinM2) / made.studyMinM2, 1, 1e-6);
}

TEST(PlaceContributions, AllCellsOfTheStudyGiveItsOwnContributions) {
    const City city = makeGridSample({.buildings = 200}).value();
    const Box2 box = bounds(city);
    StudySettings settings = atNoon("auto");
    settings.receivers.cellM = 4;
    settings.region = {"All", {{rectangle(box.low.x, box.low.y, box.high.x, box.high.y), {}}}};
    settings.contributions = settings.byMonth = true;
    const Study study = studied(city, settings);
    const auto whole = listContributions(study.city, *study.breakdown, study.sun.dayCount());
    const PlaceContributions made =
        attributed(study, {"All", PlaceKind::park, settings.region.polygons, "made up"});
    ASSERT_EQ(made.rows.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(made.rows[i].building, whole[i].building);
        EXPECT_DOUBLE_EQ(made.rows[i].attributedMinM2, whole[i].attributedMinM2);
        EXPECT_DOUBLE_EQ(made.rows[i].soleMin, whole[i].soleMin);
    }
}

// North of both towers, on the cells that its sun was measured on.
TEST(PlaceContributions, OfAMeasuredPlaceTheyAddUpToTheShadowOfItsCells) {
    SunByPlaceSettings settings;
    settings.study = atNoon("horizon");
    NoProgress quiet;
    const auto sun = compareSunByPlace(std::vector<NamedCity>{{"Now", twoTowers()}},
                                       {square("Yard", 0, 52, 20, 92), square("Inside", 4, 4, 16, 16)},
                                       settings, quiet, {});
    ASSERT_TRUE(sun) << sun.error().text();
    const auto made = computePlaceContributions(*sun, 0, {}, quiet, {});
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_EQ(made->cells, sun->baseline.sun[0].cells);
    ASSERT_FALSE(made->rows.empty());
    const double shadowMin = sun->baseline.field.sunlitMinutesPerDay - 60 * sun->baseline.sun[0].meanHours;
    EXPECT_NEAR(sumOfRows(made->rows, &Contribution::attributedMin), shadowMin, 1e-6 * shadowMin);
    EXPECT_FALSE(computePlaceContributions(*sun, 1, {}, quiet, {})) << "a tower stands on all of it";
}

// A lower sun than in the period: other minutes, of the same cells.
TEST(PlaceContributions, OfADateTheyAddUpToTheShadowOfThatDay) {
    SunByPlaceSettings settings;
    settings.study = atNoon("horizon");
    settings.dates = {parseDate("2026-12-21").value(), parseDate("2026-06-21").value()};
    NoProgress quiet;
    const auto sun = compareSunByPlace(std::vector<NamedCity>{{"Now", twoTowers()}},
                                       {square("Yard", 0, 52, 20, 92)}, settings, quiet, {});
    ASSERT_TRUE(sun) << sun.error().text();
    std::vector<ContributionTable> tables;
    for (std::size_t date = 0; date < 2; ++date) {
        const auto made = computePlaceContributions(*sun, 0, date, quiet, {});
        ASSERT_TRUE(made) << made.error().text();
        EXPECT_EQ(made->days, 1);
        EXPECT_EQ(made->period.start, settings.dates[date]);
        const double shadowMin = 60 * (settings.study.period.hours - sun->baseline.sun[0].dateHours[date]);
        EXPECT_NEAR(sumOfRows(made->rows, &Contribution::attributedMin), shadowMin, 1e-6 * 60);
        EXPECT_NEAR(made->sunlitMinutesPerDay, 60 * settings.study.period.hours, 1e-9);
        tables = withContributions(tables, makeContributionTable(*made));
    }
    EXPECT_EQ(tables.size(), 2) << "one of each date";
}

// Cells of 2 m whose shares of the place are 1, 1, 1 and 0.5 from west to east, in three rows. The tower
// takes from each what the field of the place states there.
TEST(PlaceContributions, ACellOnTheEdgeOfAMeasuredPlaceCountsByItsShare) {
    SunByPlaceSettings settings;
    settings.study = atNoon("horizon");
    settings.smallCellM = settings.study.receivers.cellM;
    NoProgress quiet;
    const auto sun = compareSunByPlace(std::vector<NamedCity>{{"Now", twoTowers()}},
                                       {square("Beside", 14, 52, 21, 58)}, settings, quiet, {});
    ASSERT_TRUE(sun) << sun.error().text();
    const SunOfPlace& of = sun->baseline.sun[0];
    EXPECT_DOUBLE_EQ(of.areaM2, 7 * 6);
    const auto made = computePlaceContributions(*sun, 0, {}, quiet, {});
    ASSERT_TRUE(made) << made.error().text();
    const ShadowField& field = sun->baseline.field;
    double minM2ADay = 0, wholeMinM2ADay = 0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) {
            const int x = int(std::lround((14 - field.grid.westM) / 2)) + column;
            const int y = int(std::lround((52 - field.grid.southM) / 2)) + row;
            const auto minutes = double(field.grossMin[field.grid.index(x, y)]);
            minM2ADay += minutes * 4 * (column == 3 ? 0.5 : 1);
            wholeMinM2ADay += minutes * 4;
        }
    ASSERT_GT(std::abs(minM2ADay / 42 - wholeMinM2ADay / 48), 0.1) << "the edge is sunnier or shadier";
    EXPECT_NEAR(sumOfRows(made->rows, &Contribution::attributedMinM2), minM2ADay * 4, 1e-3);
    EXPECT_NEAR(sumOfRows(made->rows, &Contribution::attributedMin), minM2ADay / 42, 1e-6);
    const double shadowMin = sun->baseline.field.sunlitMinutesPerDay - 60 * of.meanHours;
    EXPECT_NEAR(sumOfRows(made->rows, &Contribution::attributedMin), shadowMin, 1e-6) << "as sun by place";
    EXPECT_NEAR(made->studyMinM2, minM2ADay * 4, 1e-3);
}

TEST(PlaceContributions, KeptOnesComeBackFromTheJsonOfTheirAnswer) {
    const Study study = studied(twoTowers(), atNoon("horizon"));
    const auto keptOf = [&](const char* name) {
        return makeContributionTable(attributed(study, square(name, 0, 52, 20, 92)));
    };
    std::vector<ContributionTable> all = withContributions({}, keptOf("Yard"));
    all = withContributions(all, keptOf("Lawn"));
    all = withContributions(all, keptOf("Yard"));
    ASSERT_EQ(all.size(), 2U) << "once each";
    EXPECT_EQ(withContributions("{}", {}), "{}");
    const auto back = parseContributions(nlohmann::ordered_json::parse(withContributions("{}", all)));
    ASSERT_EQ(back.size(), 2U);
    EXPECT_EQ(back[1].place, "Yard");
    EXPECT_EQ(back[1].period, statePeriod(study.settings.period));
    EXPECT_EQ(back[1].months, all[1].months);
    EXPECT_EQ(contributionsCsv(back, {}), contributionsCsv(all, {})) << "months and period, too";
    EXPECT_EQ(back[1].cells, all[1].cells);
    ASSERT_EQ(back[1].rows.size(), all[1].rows.size());
    EXPECT_EQ(back[1].rows[0].id, all[1].rows[0].id);
    EXPECT_NEAR(back[1].rows[0].soleMinM2, all[1].rows[0].soleMinM2, 0.1);
    EXPECT_THAT(contributionsCsv(all, {}), HasSubstr("place,kind,period,source_id,name,attributed_min_m2"));
    EXPECT_THAT(contributionsCsv(all, {}), HasSubstr("Yard,park,"));
}

// A polygon for each building and place, with the figures of the table; the terrain has no outline.
TEST(PlaceContributions, AreALayerOfTheBuildingsWithWhatTheyTake) {
    const City city = twoTowers();
    const Study study = studied(city, atNoon("horizon"));
    ContributionTable of = makeContributionTable(attributed(study, square("Yard", 0, 52, 20, 92)));
    ASSERT_FALSE(of.rows.empty());
    const std::size_t buildings = of.rows.size();
    of.rows.push_back({.building = {}, .id = terrainId, .name = {}, .shadow = {}});
    const ContributionLayer layer = makeContributionLayer({of}, city);
    ASSERT_EQ(layer.outlines.size(), buildings);
    ASSERT_EQ(layer.table.rows.size(), buildings);
    EXPECT_NEAR(area(layer.outlines[0]), 400, 1e-3) << "a tower of 20 x 20 m";
    const auto column = [&](std::string_view name) {
        const auto found = std::ranges::find(layer.table.columns, name, &ElementColumn::name);
        EXPECT_NE(found, layer.table.columns.end()) << name;
        return std::size_t(found - layer.table.columns.begin());
    };
    EXPECT_EQ(std::get<std::string>(layer.table.rows[0][column("place")]), "Yard");
    EXPECT_EQ(std::get<std::string>(layer.table.rows[0][column("source_id")]), of.rows[0].id);
    EXPECT_EQ(std::get<double>(layer.table.rows[0][column("share")]), of.rows[0].share);
    EXPECT_THAT(layer.style.qml, HasSubstr("attr=\"share\""));
}

TEST(PlaceContributions, PlacesWithoutCellsAndEnginesWithoutAttributionAreRefused) {
    NoProgress quiet;
    const Study study = studied(twoTowers(), atNoon("horizon"));
    const auto far = computePlaceContributions(study, square("Far", 900, 900, 950, 950), quiet, {});
    ASSERT_FALSE(far);
    EXPECT_THAT(far.error().text(), HasSubstr("Far"));
    const auto exact = computePlaceContributions(studied(twoTowers(), atNoon("projected")),
                                                 square("Gap", 6, 22, 14, 28), quiet, {});
    ASSERT_FALSE(exact);
    EXPECT_THAT(exact.error().text(), HasSubstr("Choose one of: horizon, auto"));
}

TEST(PlaceContributions, AStopRequestEndsIt) {
    NoProgress quiet;
    std::stop_source stop;
    stop.request_stop();
    const auto made = computePlaceContributions(studied(twoTowers(), atNoon("horizon")),
                                                square("Gap", 6, 22, 14, 28), quiet, stop.get_token());
    ASSERT_FALSE(made);
    EXPECT_TRUE(isCancelled(made.error()));
}

TEST(Contributions, TheTableStatesEachFigureAndTheTerrainLast) {
    ShadowBreakdown breakdown;
    breakdown.grid = {0, 0, 2, 2, 1};
    breakdown.sets.names = {"all"};
    breakdown.cells = {0, 1};
    breakdown.minutes = {{90, 30}};
    breakdown.buildings = {{0, {120}, {0}}, {1, {240}, {60}}};
    breakdown.terrain = BuildingShadow{0, {120}, {120}};
    const auto rows = listContributions(twoTowers(), breakdown, 3);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].building, 1U) << "the largest first";
    EXPECT_DOUBLE_EQ(rows[0].share, 0.5);
    EXPECT_DOUBLE_EQ(rows[0].attributedMin, 240.0 / (2 * 4 * 3));
    EXPECT_DOUBLE_EQ(rows[0].soleMin, 60.0 / (2 * 4 * 3));
    EXPECT_FALSE(rows[2].building);
    const std::string csv = contributionsCsv(rows, breakdown.sets, {});
    EXPECT_THAT(csv, HasSubstr("building,source_id,name,attributed_min_m2,sole_min_m2,share,"));
    EXPECT_THAT(csv, HasSubstr(",terrain,terrain,120.0,120.0,0.25"));
    const auto columns = contributionColumns(rows, 2);
    EXPECT_EQ(columns[0].values, (std::vector<double>{120, 240}));
    EXPECT_EQ(columns.size(), 5U);
}

// Trees on open ground, bare at atNoon().
City grove(std::vector<glm::dvec2> places) {
    City city = twoTowers();
    Trees trees{{}, {120, 300}};
    for (const glm::dvec2 place : places)
        trees.trees.push_back({.sourceId = "tree " + std::to_string(trees.trees.size()),
                               .species = "Tilia",
                               .place = place,
                               .heightM = 12,
                               .crownBaseM = 2,
                               .crownDiameterM = 10,
                               .leafOnTransmissivity = 0.05F,
                               .leafOffTransmissivity = 0.6F});
    city.trees = std::make_shared<const Trees>(trees);
    return city;
}

Study studiedByTree(const City& city) {
    StudySettings settings = atNoon("horizon");
    settings.contributions = true;
    return studied(city, settings);
}

// Minutes a day that trees of a column add, mean over the cells.
double addedMin(const Study& study, TreeColumns column) {
    return computeStatistics(fieldOfColumn(study.field, column)).meanGrossMin - study.statistics.meanGrossMin;
}

TEST(TreeContributions, OneTreeAloneHasAllThatCrownsTake) {
    const Study study = studiedByTree(grove({{60, -40}}));
    const std::vector<TreeContribution> rows = listTreeContributions(study);
    ASSERT_EQ(rows.size(), 1U);
    ASSERT_EQ(rows[0].columns.size(), 2U);
    EXPECT_EQ(rows[0].columns[0].first, TreeColumns::evergreen);
    for (const auto& [column, one] : rows[0].columns) {
        const double added = addedMin(study, column);
        EXPECT_GT(added, 0.05);
        EXPECT_NEAR(one.attributedMin, added, 0.03 * added);
        EXPECT_NEAR(one.soleMin, one.attributedMin, 1e-9);
        EXPECT_EQ(one.id, "tree 0");
        EXPECT_EQ(one.name, "Tilia");
    }
    EXPECT_EQ(study.byTree->cells, study.receivers.cells.size()) << "few rays: all cells";
}

// Of two trees in one place each is charged with half, and felling one gives back less than that.
TEST(TreeContributions, TreesAddUpAndAreSoleForLess) {
    const Study study = studiedByTree(grove({{60, -40}, {60, -40}, {-60, 100}}));
    const std::vector<TreeContribution> rows = listTreeContributions(study);
    ASSERT_EQ(rows.size(), 3U);
    for (const std::size_t column : {0U, 1U}) {
        double sum = 0;
        for (const TreeContribution& row : rows) sum += row.columns[column].second.attributedMin;
        const double added = addedMin(study, rows[0].columns[column].first);
        EXPECT_NEAR(sum, added, 0.03 * added);
    }
    EXPECT_EQ(rows[0].tree, 2U) << "alone, it takes most";
    const Contribution &one = rows[1].columns[0].second, &other = rows[2].columns[0].second;
    EXPECT_NEAR(one.attributedMin, other.attributedMin, 1e-9);
    EXPECT_LT(one.soleMin, 0.5 * one.attributedMin);
    const std::string csv = treeContributionsCsv(rows, study.city, study.provenance);
    EXPECT_THAT(csv,
                testing::StartsWith("source_id,species,lon_deg,lat_deg,share_evergreen,"
                                    "attributed_min_day_evergreen,sole_min_day_evergreen,share_seasonal,"));
    EXPECT_THAT(csv, HasSubstr("\ntree 2,Tilia,"));
    EXPECT_FALSE(studied(grove({{60, -40}}), atNoon("horizon")).byTree) << "not asked for";
    EXPECT_FALSE(studiedByTree(grove({})).byTree);
}

std::size_t columnOf(const ContributionLayer& layer, std::string_view name) {
    const auto found = std::ranges::find(layer.table.columns, name, &ElementColumn::name);
    EXPECT_NE(found, layer.table.columns.end()) << name;
    return std::size_t(found - layer.table.columns.begin());
}

// A regular polygon of 32 corners in a circle of 10 m: 78.04 m2.
TEST(TreeContributions, AreALayerOfCrowns) {
    const Study study = studiedByTree(grove({{60, -40}, {-60, 100}}));
    const std::vector<TreeContribution> rows = listTreeContributions(study);
    ASSERT_EQ(rows.size(), 2U);
    const ContributionLayer layer = makeTreeLayer(rows, study.city);
    ASSERT_EQ(layer.outlines.size(), 2U);
    EXPECT_NEAR(area(layer.outlines[0]), 78.04, 0.01);
    const glm::vec2 middle = 0.5F * (bounds(layer.outlines[0]).low + bounds(layer.outlines[0]).high);
    EXPECT_NEAR(glm::distance(glm::dvec2(middle), study.city.trees->trees[rows[0].tree].place), 0, 1e-3);
    const auto& values = layer.table.rows[0];
    EXPECT_EQ(std::get<std::string>(values[columnOf(layer, "species")]), "Tilia");
    EXPECT_EQ(std::get<double>(values[columnOf(layer, "crown_m")]), 10);
    EXPECT_EQ(std::get<double>(values[columnOf(layer, "share_evergreen")]), rows[0].columns[0].second.share);
    EXPECT_EQ(std::get<double>(values[columnOf(layer, "sole_min_day_seasonal")]),
              rows[0].columns[1].second.soleMin);
    EXPECT_THAT(layer.style.qml, HasSubstr("attr=\"share_seasonal\""));
}

TEST(PlaceContributions, TheLayerHasTheCrownsBesideTheBuildings) {
    const Study study = studied(grove({{26, 57}}), atNoon("horizon"));
    ContributionTable of = makeContributionTable(attributed(study, square("Yard", 0, 52, 20, 92)));
    ASSERT_EQ(of.trees.size(), 1U);
    ASSERT_FALSE(of.rows.empty());
    const ContributionLayer layer = makeContributionLayer({of}, study.city);
    ASSERT_EQ(layer.outlines.size(), of.rows.size() + 1);
    const auto &building = layer.table.rows.front(), &tree = layer.table.rows.back();
    EXPECT_EQ(std::get<std::string>(building[columnOf(layer, "what")]), "building");
    EXPECT_TRUE(std::isnan(std::get<double>(building[columnOf(layer, "share_seasonal")])));
    EXPECT_EQ(std::get<std::string>(tree[columnOf(layer, "what")]), "tree");
    EXPECT_EQ(std::get<std::string>(tree[columnOf(layer, "source_id")]), "tree 0");
    EXPECT_EQ(std::get<std::string>(tree[columnOf(layer, "name")]), "Tilia");
    const auto& columns = of.trees[0].columns;
    EXPECT_EQ(std::get<double>(tree[columnOf(layer, "share")]), columns.back().second.share);
    EXPECT_EQ(std::get<double>(tree[columnOf(layer, "share_evergreen")]), columns.front().second.share);
    EXPECT_NEAR(area(layer.outlines.back()), 78.04, 0.01);
    City felled = study.city;
    felled.trees.reset();
    EXPECT_EQ(makeContributionLayer({of}, felled).outlines.size(), of.rows.size()) << "it has no outline";
}

// Not each to an end of its own.
TEST(PlaceContributions, ProgressOfBuildingsAndTreesIsOne) {
    class Heard final : public Progress {
    public:
        void report(double fraction, std::string_view stage) override {
            const std::lock_guard lock(mutex_);
            stages.emplace(stage);
            if (fraction > 1 - 1e-9) last.emplace(stage);
        }
        std::set<std::string> stages, last;  ///< all, and those that came to the end

    private:
        std::mutex mutex_;
    };
    const Study study = studied(grove({{26, 57}}), atNoon("horizon"));
    Heard heard;
    const auto made = computePlaceContributions(study, square("Yard", 0, 52, 20, 92), heard, {});
    ASSERT_TRUE(made) << made.error().text();
    ASSERT_FALSE(made->trees.empty());
    EXPECT_GE(heard.stages.size(), 2U);
    EXPECT_EQ(heard.last.size(), 1U) << "one stage ends the whole";
}

// North of both towers stand two trees, in one place; a third shades another place.
TEST(PlaceContributions, TreesRankWithBuildingsAndAllAddUpToTheShadowWithTrees) {
    SunByPlaceSettings settings;
    settings.study = atNoon("horizon");
    NoProgress quiet;
    const auto sun =
        compareSunByPlace(std::vector<NamedCity>{{"Now", grove({{40, 60}, {40, 60}, {-80, 150}})}},
                          {square("Lawn", 18, 56, 48, 96)}, settings, quiet, {});
    ASSERT_TRUE(sun) << sun.error().text();
    const auto made = computePlaceContributions(*sun, 0, {}, quiet, {});
    ASSERT_TRUE(made) << made.error().text();
    ASSERT_EQ(made->trees.size(), 2U) << "the third does not reach it";
    const double sunlit = sun->baseline.field.sunlitMinutesPerDay;
    for (const SunWithTrees& with : sun->baseline.withTrees) {
        const auto ranked = rankWithTrees(made->rows, made->trees, with.column);
        ASSERT_EQ(ranked.size(), made->rows.size() + 2);
        const double shadowMin = sunlit - 60 * with.sun[0].meanHours;
        EXPECT_GT(shadowMin, sunlit - 60 * sun->baseline.sun[0].meanHours + 1);
        EXPECT_NEAR(sumOfRows(ranked, &Contribution::attributedMin), shadowMin, 0.02 * shadowMin);
        EXPECT_NEAR(sumOfRows(ranked, &Contribution::share), 1, 1e-9);
        EXPECT_TRUE(std::ranges::is_sorted(ranked, std::ranges::greater{}, &Contribution::attributedMinM2));
        EXPECT_EQ(std::ranges::count_if(ranked, &Contribution::isTree), 2);
    }
    EXPECT_EQ(nameOf(made->trees[0].columns[0].second), "Tilia (tree 0)");
}

TEST(PlaceContributions, TreesComeBackFromTheJsonOfTheirAnswer) {
    const Study study = studied(grove({{40, 60}}), atNoon("horizon"));
    const ContributionTable table = makeContributionTable(attributed(study, square("Lawn", 18, 56, 48, 96)));
    ASSERT_EQ(table.trees.size(), 1U);
    const std::string json = withContributions("{}", {table});
    EXPECT_THAT(json, HasSubstr("\"attributed_min_m2_seasonal\""));
    const auto back = parseContributions(nlohmann::ordered_json::parse(json));
    ASSERT_EQ(back.at(0).trees.size(), 1U);
    EXPECT_EQ(back[0].trees[0].columns.size(), 2U);
    EXPECT_EQ(placeTreesCsv(back, {}), placeTreesCsv({table}, {}));
    EXPECT_THAT(placeTreesCsv(back, {}), HasSubstr(",seasonal,tree 0,Tilia,"));
    EXPECT_TRUE(back[0].trees[0].columns[0].second.isTree);
    const ContributionTable bare = makeContributionTable(
        attributed(studied(twoTowers(), atNoon("horizon")), square("Lawn", 18, 56, 48, 96)));
    EXPECT_EQ(withContributions("{}", {bare}).find("\"trees\""), std::string::npos);
}

TEST(Contributions, RankTreesByWhatTheyAreChargedWithAndTheTerrainLast) {
    const std::vector<Contribution> rows{{.id = "a", .attributedMinM2 = 50},
                                         {.id = "b", .attributedMinM2 = 10},
                                         {.id = terrainId, .attributedMinM2 = 20}};
    const auto tree = [](const char* id, double evergreen, double seasonal) {
        return TreeContribution{
            0,
            {{TreeColumns::evergreen, {.id = id, .attributedMinM2 = evergreen, .isTree = true}},
             {TreeColumns::seasonal, {.id = id, .attributedMinM2 = seasonal, .isTree = true}}}};
    };
    const std::vector<TreeContribution> trees{tree("t", 60, 15), tree("u", 60, 5), tree("v", 8, 0)};
    const auto idsOf = [&](TreeColumns column) {
        std::vector<std::string> ids;
        for (const Contribution& one : rankWithTrees(rows, trees, column)) ids.push_back(one.id);
        return ids;
    };
    EXPECT_EQ(idsOf(TreeColumns::seasonal), (std::vector<std::string>{"a", "t", "b", "u", terrainId}));
    EXPECT_EQ(idsOf(TreeColumns::evergreen), (std::vector<std::string>{"t", "u", "a", "b", "v", terrainId}));
    EXPECT_DOUBLE_EQ(rankWithTrees(rows, trees, TreeColumns::seasonal)[0].share, 0.5);
    EXPECT_EQ(chooseRankedColumn(trees, TreeColumns::evergreen), TreeColumns::evergreen);
    EXPECT_EQ(chooseRankedColumn(trees, TreeColumns::without), TreeColumns::seasonal);
    EXPECT_EQ(chooseRankedColumn({}, TreeColumns::seasonal), TreeColumns::without);
}

}  // namespace
}  // namespace noonmark
