#include "scenarios/impact/impact.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/city/trees/tree_facts.h"
#include "core/describe/command_options.h"
#include "core/engines/common/shadow_reach.h"
#include "core/study/review_study.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/impact/proposal_region.h"
#include "scenarios/project/results/saved_figures_json.h"
#include "scenarios/scenario.h"
#include "scenarios/weights/score_text.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

ImpactSettings morning(const std::string& engine = "ray") {
    ImpactSettings settings;
    settings.study.region = makeRegionFromLocalBox({{-60, -40}, {160, 120}});
    settings.study.receivers.cellM = 2;
    settings.study.period = {.hours = 6, .stepMinutes = 10, .zone = "America/New_York"};
    settings.study.engine = engine;
    return settings;
}

ImpactStudy impactOf(const City& before, const City& after, const ImpactSettings& settings = morning()) {
    NoProgress progress;
    return runImpact(before, after, settings, progress, {}).value();
}

City with(const City& city, const std::vector<Edit>& edits) { return applyEdits(city, edits).value().city; }

Edit tower(const std::string& id, float west, float topM) {
    return AddBuilding{shared(house(id, box(west, 40, west + 20, 60), topM))};
}

TEST(Impact, OfNothingIsNothing) {
    const ImpactFigures figures = computeFigures(impactOf(threeHouses(), threeHouses()).total, 0);
    EXPECT_GT(figures.receiverAreaM2, 30000);
    EXPECT_EQ(figures.gross.anyMoreShadowM2, 0);
    EXPECT_EQ(figures.gross.anyLessShadowM2, 0);
    EXPECT_EQ(figures.shadowAreaChangeM2, 0);
    EXPECT_EQ(figures.becameBuildingM2, 0);
}

TEST(Impact, OfATowerInTheOpenIsItsShadow) {
    City empty = threeHouses();
    empty.buildings.clear();
    const ImpactStudy study = impactOf(empty, with(empty, {tower("t", 0, 60)}));
    for (std::size_t i = 0; i < study.after.grossMin.size(); ++i) {
        if (std::isnan(study.after.grossMin[i])) continue;
        ASSERT_EQ(study.total.grossMin[i], study.after.grossMin[i]);
        ASSERT_EQ(study.total.continuousMin[i], study.after.continuousMin[i]);
    }
    const ImpactFigures figures = computeFigures(study.total);
    EXPECT_EQ(figures.becameBuildingM2, 400);
    EXPECT_GT(figures.gross.moreShadowM2, 0);
    EXPECT_LT(figures.gross.moreShadowM2, figures.gross.anyMoreShadowM2);
    EXPECT_EQ(figures.gross.lessShadowM2, 0);
}

TEST(Impact, SaysWhatStandsOrReachesBeyondTheRegion) {
    City empty = threeHouses();
    empty.buildings.clear();
    const auto answerOf = [&](float west, float topM) {
        const City after = with(empty, {tower("t", west, topM)});
        return ImpactAnswer{
            "Existing", "Mill", morning(), impactOf(empty, after), {}, keepOwnBuildings(after, empty)};
    };
    const auto beyond = [&](float west, float topM) {
        const auto words = describeBeyond(answerOf(west, topM));
        return words ? formatText(*words) : std::string();
    };
    EXPECT_EQ(beyond(20, 4), "") << "a low house in the middle";
    EXPECT_THAT(beyond(155, 4), testing::HasSubstr("A part of what Mill builds stands outside the region"));
    EXPECT_THAT(beyond(170, 60), testing::HasSubstr("What Mill builds stands outside the region"));
    EXPECT_THAT(beyond(20, 200), testing::HasSubstr("more than 30 min a day reaches the region's edge"));
    const AnswerPage page = makePage(answerOf(170, 60), LegendChoice());
    ASSERT_FALSE(page.findings.empty());
    EXPECT_THAT(formatText(page.findings.back()), testing::HasSubstr("outside the region"));
    EXPECT_THAT(impactJson(answerOf(170, 60)), testing::HasSubstr(R"("proposal_in_region": "none")"));
    EXPECT_THAT(impactJson(answerOf(20, 4)), testing::HasSubstr(R"("changes_at_edge": false)"));
}

TEST(Impact, ARegionAroundAProposalIsAsLargeAsBeforeOrAsThatNeeds) {
    const auto mill = shared(house("Mill", box(1000, 40, 1020, 60), 60));
    const Region around = makeRegionAround({mill}, makeRegionFromLocalBox({{-60, -40}, {160, 120}}));
    EXPECT_EQ(bounds(around).low, glm::vec2(900, -30));
    EXPECT_EQ(bounds(around).high, glm::vec2(1120, 130));
    EXPECT_EQ(around.name, "around Mill");
    EXPECT_EQ(findInRegion({mill}, around), InRegion::whole);
    const Region small = makeRegionAround({mill}, makeRegionFromLocalBox({{0, 0}, {10, 10}}));
    EXPECT_EQ(bounds(small).low, glm::vec2(950, -10));
    EXPECT_EQ(bounds(small).high, glm::vec2(1070, 110));
}

TEST(Impact, ThereAndBackAgainIsTheSameWithTheOtherSign) {
    const City before = threeHouses();
    const City after = with(before, {tower("t", 0, 60), Demolish{"c"}});
    const ImpactStudy there = impactOf(before, after), back = impactOf(after, before);
    for (std::size_t i = 0; i < there.total.grossMin.size(); ++i) {
        if (std::isnan(there.total.grossMin[i]))
            ASSERT_TRUE(std::isnan(back.total.grossMin[i]));
        else
            ASSERT_EQ(there.total.grossMin[i], -back.total.grossMin[i]);
    }
    const ImpactFigures to = computeFigures(there.total), fro = computeFigures(back.total);
    EXPECT_EQ(to.gross.moreShadowM2, fro.gross.lessShadowM2);
    EXPECT_EQ(to.becameBuildingM2, fro.becameGroundM2);
    EXPECT_EQ(to.becameGroundM2, 100);
    EXPECT_EQ(to.becameBuildingM2, 400);
}

TEST(Impact, OfTowersFarApartAddsUp) {
    City empty = threeHouses();
    empty.buildings.clear();
    ImpactSettings settings = morning();
    settings.byBuilding = true;
    settings.study.region = makeRegionFromLocalBox({{-100, 0}, {1200, 200}});
    const City after = with(empty, {tower("t", 0, 20), tower("u", 1000, 20)});
    const ImpactStudy study = impactOf(empty, after, settings);
    ASSERT_EQ(study.byBuilding.size(), 2U);
    EXPECT_EQ(study.byBuilding[0].id, "t");
    const double t = computeFigures(study.byBuilding[0].impact).shadowAreaChangeM2;
    const double u = computeFigures(study.byBuilding[1].impact).shadowAreaChangeM2;
    EXPECT_GT(t, 100);
    EXPECT_NEAR(t + u, computeFigures(study.total).shadowAreaChangeM2, 1e-6 * (t + u));
}

TEST(Impact, FiguresOfAFieldByHand) {
    Impact impact{.grid = {.cellM = 2, .columns = 3, .rows = 2}};
    impact.grossMin = {none, 40, 30, -31, -5, 0};
    impact.continuousMin = {none, 10, 0, 0, -70, 0};
    impact.change.assign(6, CellChange::none);
    impact.change[0] = CellChange::becameBuilding;
    impact.sunlitMinutesPerDay = 340;
    const ImpactFigures figures = computeFigures(impact);
    EXPECT_EQ(figures.receiverAreaM2, 20);
    EXPECT_EQ(figures.gross.moreShadowM2, 4);  // 30 does not exceed the threshold of 30
    EXPECT_EQ(figures.gross.lessShadowM2, 4);
    EXPECT_EQ(figures.gross.anyMoreShadowM2, 8);
    EXPECT_EQ(figures.gross.anyLessShadowM2, 8);
    EXPECT_EQ(figures.gross.maxMoreShadowMin, 40);
    EXPECT_EQ(figures.gross.maxLessShadowMin, 31);
    EXPECT_NEAR(figures.gross.meanMin, 34.0 / 5, 1e-9);
    EXPECT_NEAR(figures.shadowAreaChangeM2, 34.0 * 4 / 340, 1e-9);
    EXPECT_EQ(figures.continuous.lessShadowM2, 4);
    EXPECT_EQ(figures.becameBuildingM2, 4);
    const Region east = makeRegionFromLocalBox({{2, 0}, {6, 4}});
    EXPECT_EQ(computeFigures(impact, east, 4).gross.lessShadowM2, 4);
    EXPECT_EQ(computeFigures(impact, east, 4).becameBuildingM2, 0);
}

TEST(Impact, WithoutRunsTheirChangeIsUnknown) {
    Impact impact{.grid = {.cellM = 2, .columns = 3, .rows = 1}};
    impact.grossMin = {none, 40, -31};
    impact.continuousMin = {none, none, none};
    impact.change.assign(3, CellChange::none);
    impact.sunlitMinutesPerDay = 340;
    ImpactAnswer answer;
    answer.settings.thresholdsMin = {30};
    answer.study.total = impact;
    const ImpactFigures figures = computeFigures(impact);
    EXPECT_EQ(figures.gross.moreShadowM2, 4);
    EXPECT_FALSE(hasRuns(figures));
    EXPECT_TRUE(std::isnan(figures.continuous.anyMoreShadowM2)) << "0 would say that nothing changed";
    const auto json = nlohmann::json::parse(impactJson(answer));
    EXPECT_TRUE(json["impact"][0]["continuous"].is_null());
    EXPECT_EQ(json["impact"][0]["gross"]["lost_m2"], 4);
    const std::string csv = impactCsv(answer);
    EXPECT_EQ(csv.find("nan"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",31.00,,,"), std::string::npos) << csv;
}

TEST(Impact, ItsJsonStatesTheAir) {
    ImpactAnswer answer;
    answer.settings.thresholdsMin = {30};
    answer.study.total.grid = {.cellM = 2, .columns = 1, .rows = 1};
    answer.study.total.grossMin = answer.study.total.continuousMin = {1};
    answer.study.total.change = {CellChange::none};
    answer.settings.study.pressureHPa = 850;
    answer.settings.study.temperatureC = -12.5;
    const auto json = nlohmann::json::parse(impactJson(answer));
    EXPECT_EQ(json["observer"]["pressure_hpa"], 850);
    EXPECT_EQ(json["observer"]["temperature_c"], -12.5);
    const auto score = nlohmann::json::parse(scoreJson({.settings = answer.settings.study}));
    EXPECT_EQ(score["observer"], json["observer"]);
}

TEST(Impact, ItsThresholdsAreFieldsOfItsSettings) {
    ImpactAnswer answer;
    answer.from = "Existing";
    answer.to = "Tower";
    answer.settings.study.region = makeRegionFromLocalBox({{0, 0}, {4, 4}});
    ASSERT_TRUE(
        impactFields().of(answer.settings).set(impactFields().rows()[0], std::vector<double>{12.5, 45}));
    ASSERT_TRUE(impactFields().of(answer.settings).set(impactFields().rows()[1], true));
    const auto json = nlohmann::json::parse(impactJson(answer));
    EXPECT_EQ(json["thresholds_min"], (std::vector<double>{12.5, 45}));
    EXPECT_EQ(json["each_new_building"], true);
    EXPECT_EQ(json["impact"].size(), 2U);
    EXPECT_EQ(json["impact"][1]["threshold_min"], 45);
    EXPECT_THAT(
        listOptions(impactFields().of(answer.settings)),
        testing::ElementsAre(CommandOption{"--threshold", {"12.5,45"}}, CommandOption{"--by-building", {}}));
}

TEST(Impact, RefusesThresholdsOutOfRangeOrNone) {
    const City city = threeHouses();
    NoProgress quiet;
    for (const std::vector<double>& thresholds : {std::vector<double>{}, {-1}, {30, 1441}}) {
        ImpactSettings settings = morning();
        settings.thresholdsMin = thresholds;
        const auto refused = runImpact(city, city, settings, quiet, {});
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().where, "threshold");
    }
}

TEST(Impact, EveryEngineSeesTheSame) {
    const City before = threeHouses();
    const City after = with(before, {tower("t", 0, 60)});
    const double truth = computeFigures(impactOf(before, after).total).shadowAreaChangeM2;
    for (const char* engine : {"projected", "horizon"})
        EXPECT_NEAR(computeFigures(impactOf(before, after, morning(engine)).total).shadowAreaChangeM2, truth,
                    0.01 * truth)
            << engine;
}

// Houses in rows and columns, 8 m apart, north of the x axis.
City manyHouses(int rows, int columns) {
    City city = threeHouses();
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const float west = 8.0F * float(column), south = 8.0F * float(row);
            city.buildings.push_back(shared(
                house(std::to_string(row * columns + column), box(west, south, west + 3, south + 3), 6)));
        }
    return city;
}

TEST(Impact, TheEngineAutoIsAskedOnceForBothFields) {
    City empty = threeHouses();
    empty.buildings.clear();
    ImpactSettings settings = morning("auto");
    settings.study.region = makeRegionFromLocalBox({{0, 0}, {80, 160}});
    settings.study.period.days = 200;  // for the empty city alone auto would choose projected shadows
    settings.study.period.hours = 8;
    settings.study.period.stepMinutes = 1;
    const ImpactStudy study = impactOf(empty, manyHouses(20, 20), settings);
    EXPECT_EQ(study.before.engineKey, "horizon");
    EXPECT_EQ(study.after.engineKey, "horizon");
    EXPECT_THAT(study.total.engine, testing::HasSubstr("since the period is long"));
    const ImpactStudy alone = impactOf(empty, empty, settings);
    EXPECT_EQ(alone.before.engineKey, "projected");
}

// Few bins make the error visible. The sample covers all cells, so its error equals the whole difference.
TEST(Impact, StatesTheErrorOfTheChange) {
    ImpactSettings settings = morning("horizon");
    settings.study.engineSettings["bin"] = 2;
    settings.study.receivers.cellM = 5;
    settings.study.period.stepMinutes = 1;
    settings.study.errorSample.receivers = 10'000;
    const City before = threeHouses(), after = with(before, {tower("t", 0, 60)});
    const ImpactStudy study = impactOf(before, after, settings);
    ImpactSettings byRays = settings;
    byRays.study.engine = "ray";
    byRays.study.engineSettings.clear();
    const ImpactStudy truth = impactOf(before, after, byRays);
    EXPECT_FALSE(truth.error);
    ASSERT_TRUE(study.error);
    double sum = 0, maximum = 0;
    std::size_t cells = 0;
    for (std::size_t i = 0; i < study.total.grossMin.size(); ++i) {
        if (std::isnan(study.total.grossMin[i])) continue;
        const double off = std::abs(double(study.total.grossMin[i]) - double(truth.total.grossMin[i]));
        sum += off, maximum = std::max(maximum, off), ++cells;
    }
    EXPECT_GT(maximum, 0);
    EXPECT_GT(study.error->receivers, cells * 9 / 10);  // the receivers that the sample's points hit
    EXPECT_NEAR(study.error->gross.meanMin, sum / double(cells), 0.2 * sum / double(cells));
    EXPECT_LE(study.error->gross.maxMin, maximum + 1e-3);
    const std::vector<ShownError> shown = listErrors(*study.error, true);
    ASSERT_EQ(shown.size(), 2U);
    EXPECT_EQ(shown[0].facts.key, "change_gross");
    EXPECT_EQ(shown[0].p99, study.error->gross.p99Min);
    EXPECT_EQ(shown[1].facts.key, "change_continuous");
    EXPECT_EQ(shown[1].largest, study.error->continuous.maxMin);
    settings.study.errorSample.receivers = 0;
    EXPECT_FALSE(impactOf(before, after, settings).error);
}

TEST(Impact, WhatTheChosenEngineRefusesGoesToRaysInBothFields) {
    ImpactSettings settings = morning("auto");
    settings.study.region = makeRegionFromLocalBox({{0, -360}, {1, 140}});
    settings.study.receivers.cellM = 1;
    settings.study.period.from = std::chrono::hours(0);
    settings.study.period.hours = 24;
    settings.study.period.stepMinutes = 1.0 / 60;  // more steps per day than the sweep can count
    const City before = threeHouses();
    const ImpactStudy study = impactOf(before, with(before, {Demolish{"c"}}), settings);
    EXPECT_EQ(study.before.engineKey, "ray");
    EXPECT_EQ(study.after.engineKey, "ray");
    EXPECT_THAT(study.total.engine, testing::HasSubstr("refused"));
}

// The field without a building is recomputed only where the building's shadow can fall.
TEST(Impact, ByBuildingIsThatOfTheWholeFieldToTheLastBit) {
    City before = manyHouses(6, 6);
    const City after = with(before, {tower("t", 0, 60), tower("low", 60, 4), Demolish{"c"}});
    for (const char* engine : {"ray", "projected", "horizon", "auto"}) {
        ImpactSettings settings = morning(engine);
        settings.byBuilding = true;
        const ImpactStudy study = impactOf(before, after, settings);
        const auto common =
            findCommonReceivers(before, after, settings.study.region, settings.study.receivers).value();
        ASSERT_EQ(study.byBuilding.size(), 2U);
        for (const BuildingImpact& made : study.byBuilding) {
            NoProgress progress;
            const ShadowField whole =
                makeEngine(engine)
                    .value()
                    ->accumulate(with(after, {Demolish{made.id}}), common.receivers, study.sun, progress, {})
                    .value();
            const Impact plain = computeDifference(whole, study.after, common.change);
            for (const std::uint32_t cell : common.receivers.cells) {
                ASSERT_EQ(made.impact.grossMin[cell], plain.grossMin[cell]) << engine << ' ' << made.id;
                ASSERT_EQ(made.impact.continuousMin[cell], plain.continuousMin[cell]) << engine;
            }
        }
    }
}

TEST(Impact, ALowBuildingReachesFewReceivers) {
    const City city = with(threeHouses(), {tower("low", 60, 4)});
    const ImpactSettings settings = morning();
    const auto receivers =
        placeReceiversOnGround(city, settings.study.region, settings.study.receivers).value();
    const SunSteps sun =
        computeSunSteps(settings.study.period, makeObserver(city, settings.study), {}).value();
    const Receivers reached = findReached({city.buildings.back()}, receivers, ShadowReach(sun));
    EXPECT_GT(reached.cells.size(), 100U);
    EXPECT_LT(reached.cells.size(), receivers.cells.size() / 2);
    EXPECT_EQ(reached.grid, receivers.grid);
}

TEST(Impact, SaysWhatIsMissing) {
    NoProgress progress;
    ImpactSettings settings = morning("none");
    EXPECT_FALSE(runImpact(threeHouses(), threeHouses(), settings, progress, {}));
    settings = morning();
    settings.study.region = makeRegionFromLocalBox({{2, 2}, {8, 8}});
    EXPECT_THAT(runImpact(threeHouses(), threeHouses(), settings, progress, {}).error().what,
                testing::HasSubstr("No cell"));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(
        isCancelled(runImpact(threeHouses(), threeHouses(), morning(), progress, stop.get_token()).error()));
}

// One lime with a crown 8 m wide from 3 to 12 m, in the open, and none before.
City withLime(City city, bool evergreen = false) {
    Tree lime = completeTree({.sourceId = "lime",
                              .species = "Tilia",
                              .heightM = 12.0,
                              .crownDiameterM = 8.0,
                              .crownBaseM = 3.0,
                              .evergreen = evergreen});
    lime.place = {110, -20};
    city.trees = std::make_shared<const Trees>(Trees{.trees = {lime}, .leafDays = {100, 300}});
    return city;
}

double changeOf(const ImpactStudy& study, TreeColumns column) {
    for (const ShadeChange& shade : computeFigures(study, 30).withTrees)
        if (shade.column == column) return shade.shadowAreaChangeM2;
    ADD_FAILURE() << "no such column";
    return 0;
}

TEST(Impact, PlantingATreeAddsWhatItTakesAndFellingItGivesItBack) {
    const City bare = threeHouses();
    ImpactSettings winter = morning();
    winter.study.period.start = std::chrono::year(2026) / 1 / 15;  // leaves are on from day 100 to 300
    const ImpactStudy planted = impactOf(bare, withLime(bare), winter);
    const ImpactStudy felled = impactOf(withLime(bare), bare, winter);
    ASSERT_EQ(planted.withTrees.size(), 2U);
    EXPECT_EQ(computeFigures(planted.total, 0).shadowAreaChangeM2, 0) << "without trees nothing changes";
    const double evergreen = changeOf(planted, TreeColumns::evergreen),
                 seasonal = changeOf(planted, TreeColumns::seasonal);
    EXPECT_GT(evergreen, 0);
    EXPECT_GT(seasonal, 0) << "bare branches";
    EXPECT_LT(seasonal, evergreen / 2);
    EXPECT_NEAR(changeOf(felled, TreeColumns::evergreen), -evergreen, 1e-6 * evergreen);
    EXPECT_NEAR(changeOf(felled, TreeColumns::seasonal), -seasonal, 1e-6 * evergreen);
    EXPECT_THAT(planted.total.warnings, testing::IsEmpty());
    const ImpactStudy always = impactOf(bare, withLime(bare, true), winter);
    EXPECT_NEAR(changeOf(always, TreeColumns::seasonal), evergreen, 1e-6 * evergreen);
}

TEST(Impact, OnlyTheColumnsAskedForAreMeasured) {
    const City bare = threeHouses();
    ImpactSettings settings = morning();
    settings.study.trees = TreeColumns::seasonal;
    const ImpactStudy one = impactOf(bare, withLime(bare), settings);
    ASSERT_EQ(one.withTrees.size(), 1U);
    EXPECT_EQ(one.withTrees[0].column, TreeColumns::seasonal);
    settings.study.trees = TreeColumns::without;
    EXPECT_TRUE(impactOf(bare, withLime(bare), settings).withTrees.empty());
    settings.study.trees = TreeColumns::all;
    EXPECT_TRUE(impactOf(bare, bare, settings).withTrees.empty());
}

TEST(Impact, FilesStateTheColumnsOfTrees) {
    const City bare = threeHouses();
    ImpactAnswer answer{
        .from = "A", .to = "B", .settings = morning(), .study = impactOf(bare, withLime(bare))};
    const auto json = nlohmann::ordered_json::parse(impactJson(answer));
    const auto& first = json.at("impact").at(0);
    EXPECT_EQ(first.at("gross").at("mean_min"), 0);
    EXPECT_GT(first.at("gross_evergreen").at("mean_min"), 0);
    EXPECT_DOUBLE_EQ(first.at("shadow_area_change_m2_seasonal").get<double>(),
                     changeOf(answer.study, TreeColumns::seasonal));
    EXPECT_TRUE(json.at("definitions").contains("gross_seasonal"));
    const ImpactFigures read = parseComparison(json).all.at(0);
    ASSERT_EQ(read.withTrees.size(), 2U);
    EXPECT_EQ(read.withTrees[0].column, TreeColumns::evergreen);
    EXPECT_DOUBLE_EQ(read.withTrees[0].gross.meanMin,
                     first.at("gross_evergreen").at("mean_min").get<double>());
    const std::string csv = impactCsv(answer);
    EXPECT_THAT(csv.substr(0, csv.find('\n')),
                testing::AllOf(testing::HasSubstr("shadow_area_change_m2_evergreen"),
                               testing::HasSubstr("mean_min_seasonal")));
    const auto commas = [](const std::string& line) { return std::ranges::count(line, ','); };
    const std::string second = csv.substr(csv.find('\n') + 1);
    EXPECT_EQ(commas(csv.substr(0, csv.find('\n'))), commas(second.substr(0, second.find('\n'))));
    EXPECT_THAT(impactCsv({.from = "A", .to = "B", .settings = morning(), .study = impactOf(bare, bare)}),
                testing::Not(testing::HasSubstr("evergreen")));
}

}  // namespace
}  // namespace noonmark::tests
