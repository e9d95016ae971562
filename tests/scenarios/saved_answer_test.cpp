#include "scenarios/project/results/saved_answer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/describe/field_values.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/project/project_file.h"
#include "scenarios/project/results/save_result.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

using namespace std::chrono;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr sys_seconds keptAt = sys_days(2026y / March / 4) + hours(5) + minutes(6) + seconds(7);

Project town() {
    Project project;
    project.city = std::make_shared<const City>(threeHouses());
    project.inputs = {{"town.gpkg", 12, "ab"}};
    project.scenarios = {{"Tower", "", {AddBuilding{shared(house("t", box(12, 0, 22, 10), 40))}}}};
    return project;
}

StudySettings question() {
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({{-10, -10}, {60, 60}});
    settings.region.name = "Square";
    settings.receivers.cellM = 2;
    settings.period = {
        .start = 2026y / June / 1, .days = 2, .hours = 4, .stepMinutes = 10, .zone = "America/New_York"};
    settings.engine = "ray";
    return settings;
}

Study studied(const Project& project) {
    NoProgress progress;
    return runStudy(*project.city, question(), progress, {}).value();
}

ImpactAnswer compared(const Project& project) {
    NoProgress progress;
    ImpactAnswer answer{existingCity, "Tower", {question(), true}, {30, 60}, {}};
    answer.study =
        runImpact(*project.city, cityOf(project, "Tower")->city, answer.settings, progress, {}).value();
    return answer;
}

ScoreAnswer scored(const Project& project) {
    NoProgress progress;
    return {existingCity, question(), makeMonthlyWeights(),
            runScore(*project.city, question(), makeMonthlyWeights(), progress, {}).value()};
}

// The project after a round trip through a file.
Project saved(const Project& project) {
    const TemporaryFolder folder;
    const auto file = folder.path("kept.noonmark.gpkg");
    EXPECT_TRUE(ProjectFile::create(file, project));
    return ProjectFile::open(file)->project();
}

bool same(const std::vector<float>& a, const std::vector<float>& b) {
    return std::ranges::equal(a, b,
                              [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

TEST(SavedAnswers, AStudyComesBackWithItsFiguresAndOrigin) {
    const Study study = studied(town());
    const Project project = saved(addResult(town(), "June", existingCity, study, keptAt));
    const auto result = project.results.at(0);
    const SavedAnswer saved = readSavedAnswer(*result).value();
    EXPECT_EQ(saved.origin.at, "2026-03-04T05:06:07Z");
    EXPECT_EQ(saved.origin.engine, study.field.engine);
    EXPECT_EQ(saved.origin.region, "Square");
    EXPECT_EQ(saved.origin.period, statePeriod(question().period));
    const auto& back = std::any_cast<const SavedStudy&>(saved.content);
    EXPECT_TRUE(same(back.field.grossMin, study.field.grossMin));
    EXPECT_TRUE(same(back.field.continuousMin, study.field.continuousMin));
    EXPECT_EQ(back.field.days, 2);
    EXPECT_EQ(back.field.sunlitMinutesPerDay, study.field.sunlitMinutesPerDay);
    EXPECT_EQ(back.statistics.shadowAreaM2, study.statistics.shadowAreaM2);
    EXPECT_EQ(back.statistics.receivers, study.statistics.receivers);
    EXPECT_EQ(back.steps, study.sun.steps.size());
    EXPECT_THAT(back.error, HasSubstr("ray reference itself"));
    EXPECT_THAT(findChangesSince(*result, saved.origin, project), IsEmpty());
}

TEST(SavedAnswers, AnImpactComesBackWithThresholdsAndBuildings) {
    const ImpactAnswer answer = compared(town());
    const Project project = saved(addResult(town(), "Tower", answer, keptAt));
    const auto result = project.results.at(0);
    const SavedAnswer saved = readSavedAnswer(*result).value();
    const auto& back = std::any_cast<const SavedImpact&>(saved.content);
    const ComparisonFigures wanted = computeFigures(answer);
    EXPECT_TRUE(same(back.impact.grossMin, answer.study.total.grossMin));
    EXPECT_EQ(back.impact.change, answer.study.total.change) << "what was built over";
    EXPECT_EQ(std::ranges::count(back.impact.change, CellChange::becameBuilding), 25);
    ASSERT_TRUE(back.sides);
    EXPECT_TRUE(same(back.sides->before.grossMin, answer.study.before.grossMin));
    EXPECT_TRUE(same(back.sides->after.grossMin, answer.study.after.grossMin));
    ASSERT_EQ(back.figures.all.size(), 2U);
    EXPECT_EQ(back.figures.all[1].thresholdMin, 60);
    EXPECT_EQ(back.figures.all[0].gross.moreShadowM2, wanted.all[0].gross.moreShadowM2);
    EXPECT_EQ(back.figures.all[0].becameBuildingM2, 100);
    ASSERT_EQ(back.figures.byBuilding.size(), 1U);
    EXPECT_EQ(back.figures.byBuilding[0].name, "t");
    EXPECT_EQ(back.figures.byBuilding[0].figures.gross.anyMoreShadowM2,
              wanted.byBuilding[0].figures.gross.anyMoreShadowM2);
    EXPECT_THAT(findChangesSince(*result, saved.origin, project), IsEmpty());
}

TEST(SavedAnswers, WhatHasNoRunsComesBackWithoutThem) {
    StudySettings gross = question();
    gross.engine = "horizon";
    gross.engineSettings["runs"] = 0;
    NoProgress progress;
    const Study study = runStudy(*town().city, gross, progress, {}).value();
    ImpactAnswer answer{existingCity, "Tower", {gross, true}, {30, 60}, {}};
    answer.study =
        runImpact(*town().city, cityOf(town(), "Tower")->city, answer.settings, progress, {}).value();
    const Project project =
        saved(addResult(addResult(town(), "June", existingCity, study, keptAt), "Tower", answer, keptAt));
    EXPECT_EQ(project.results.at(0)->layers.size(), 1U);
    EXPECT_EQ(project.results.at(1)->layers.size(), 3U) << "the change, and both sides";
    const auto june = readSavedAnswer(*project.results.at(0));
    ASSERT_TRUE(june) << june.error().text();
    const auto& back = std::any_cast<const SavedStudy&>(june->content);
    EXPECT_FALSE(hasRuns(back.field));
    EXPECT_FALSE(hasRuns(back.statistics));
    EXPECT_EQ(back.statistics.meanGrossMin, study.statistics.meanGrossMin);
    EXPECT_TRUE(same(back.field.grossMin, study.field.grossMin));
    const auto tower = readSavedAnswer(*project.results.at(1));
    ASSERT_TRUE(tower) << tower.error().text();
    const auto& impact = std::any_cast<const SavedImpact&>(tower->content);
    EXPECT_FALSE(hasRuns(impact.impact));
    EXPECT_FALSE(hasRuns(impact.figures.all.at(0)));
    EXPECT_FALSE(hasRuns(impact.figures.byBuilding.at(0).figures));
    EXPECT_GT(impact.figures.all.at(0).gross.anyMoreShadowM2, 0);
}

TEST(SavedAnswers, AScoreComesBackMonthByMonth) {
    const ScoreAnswer answer = scored(town());
    const Project project = saved(addResult(town(), "Score", answer, keptAt));
    const auto result = project.results.at(0);
    const SavedAnswer saved = readSavedAnswer(*result).value();
    const auto& back = std::any_cast<const SavedScore&>(saved.content);
    EXPECT_EQ(back.weights, "default");
    EXPECT_EQ(saved.origin.weights, makeMonthlyWeights());
    EXPECT_THAT(findWeightChangesSince(saved.origin, project), IsEmpty());
    EXPECT_EQ(back.score.scoreM2, answer.score.scoreM2);
    ASSERT_EQ(back.score.months.size(), 1U);
    EXPECT_EQ(back.score.months[0].month, 2026y / June);
    EXPECT_EQ(back.score.months[0].shadowAreaM2, answer.score.months[0].shadowAreaM2);
    EXPECT_EQ(back.score.intervals.size(), 12U);
    EXPECT_TRUE(same(back.score.score, answer.score.score));
    ASSERT_EQ(back.score.errors.size(), answer.score.errors.size());
    for (std::size_t i = 0; i < answer.score.errors.size(); ++i) {
        EXPECT_EQ(back.score.errors[i].facts.key, answer.score.errors[i].facts.key);
        EXPECT_EQ(back.score.errors[i].p99, answer.score.errors[i].p99);
    }
}

Place lawn(const std::string& name, const Footprint& outline) {
    return {name, PlaceKind::park, {outline}, "drawn"};
}

SunOfCities sunny(const Project& project) {
    Footprint ring = box(-40, -40, -20, -20);
    ring.holes.push_back({{-35, -35}, {-35, -25}, {-25, -25}, {-25, -35}});
    SunByPlaceSettings settings;
    settings.study = question();
    settings.study.engine = StudySettings().engine;
    settings.enoughHours = 2.5;
    settings.lossMin = 20;
    settings.smallCellM = 0.25;
    settings.dates = {2026y / December / 21, 2026y / June / 21};
    const NamedCity cities[]{{existingCity, *project.city}, {"Tower", cityOf(project, "Tower")->city}};
    NoProgress progress;
    return compareSunByPlace(cities, {lawn("Ring", ring), lawn("Lawn", box(12, 12, 40, 40))}, settings,
                             progress, {})
        .value();
}

TEST(SavedAnswers, SunByPlaceComesBackWithOutlinesDatesAndChanges) {
    const SunOfCities answer = sunny(town());
    Project project = addResult(town(), [&] {
        SavedResult result = makeSavedResult(town(), answer, keptAt);
        result.name = "Sun";
        return result;
    }());
    project.places = answer.baseline.places;
    project = saved(project);
    const SavedResult& result = *project.results[0];
    EXPECT_EQ(result.kind, "by-place");
    EXPECT_EQ(result.scenario, "Tower");
    EXPECT_EQ(result.baseline, existingCity);
    const auto read = readSavedAnswer(result);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_THAT(findChangesSince(result, read->origin, project), IsEmpty());
    const auto& back = std::any_cast<const SavedSunByPlace&>(read->content);
    EXPECT_EQ(back.sun.baseline.places, answer.baseline.places);
    EXPECT_EQ(questionText(sunByPlaceFields().of(back.sun.baseline.settings)),
              questionText(sunByPlaceFields().of(answer.baseline.settings)));
    EXPECT_EQ(back.sun.baseline.settings.smallCellM, 0.25);
    EXPECT_EQ(back.sun.baseline.months, answer.baseline.months);
    ASSERT_EQ(back.sun.baseline.seasons.size(), 1U);
    EXPECT_EQ(back.sun.baseline.seasons[0].label, answer.baseline.seasons[0].label);
    EXPECT_EQ(back.sun.baseline.partOf, answer.baseline.partOf);
    ASSERT_EQ(back.sun.compared.size(), 1U);
    for (std::size_t i = 0; i < 2; ++i) {
        const SunOfPlace &then = answer.baseline.sun[i], &now = back.sun.baseline.sun[i];
        EXPECT_NEAR(now.meanHours, then.meanHours, 1e-4);
        EXPECT_EQ(now.dateHours.size(), 2U);
        EXPECT_EQ(now.cellM, then.cellM);
        EXPECT_EQ(now.seasonHours.size(), 1U);
        EXPECT_NEAR(now.dateHours[0], then.dateHours[0], 1e-4);
        EXPECT_NEAR(now.belowShare[1], then.belowShare[1], 1e-4);
        EXPECT_NEAR(back.sun.compared[0].changes[i].meanHours, answer.compared[0].changes[i].meanHours, 1e-4);
    }
    EXPECT_LT(back.sun.compared[0].changes[1].meanHours, 0) << "north of the tower";
    const auto any = [](const CivilDate&) { return true; };
    EXPECT_EQ(possibleHoursOn(back.sun.baseline, any), possibleHoursOn(answer.baseline, any));
    EXPECT_FALSE(answer.baseline.errors.empty());
    EXPECT_EQ(errorsJson(back.sun.baseline.errors), errorsJson(answer.baseline.errors));
    EXPECT_EQ(errorsJson(back.sun.compared[0].sun.errors), errorsJson(answer.compared[0].sun.errors));
}

TEST(SavedAnswers, SunByPlaceIsOutdatedOncePlacesAreRenamedMovedOrGone) {
    Project project = town();
    const SunOfCities answer = sunny(project);
    project.places = answer.baseline.places;
    const SavedResult result = makeSavedResult(project, answer, keptAt);
    const SavedOrigin origin = readSavedOrigin(result).value();
    EXPECT_THAT(findChangesSince(result, origin, project), IsEmpty());
    const auto changesWith = [&](const auto& change) {
        Project other = project;
        change(other.places);
        return findChangesSince(result, origin, other);
    };
    EXPECT_THAT(changesWith([](auto& places) { places[1].name = "Meadow"; }),
                ElementsAre("The place 'Lawn' is gone, or has another name."));
    EXPECT_THAT(changesWith([](auto& places) { places.erase(places.begin()); }),
                ElementsAre("The place 'Ring' is gone, or has another name."));
    EXPECT_THAT(changesWith([](auto& places) { places[1].kind = PlaceKind::plaza; }),
                ElementsAre("The place 'Lawn' has another kind or outline since."));
    EXPECT_THAT(changesWith([](auto& places) { places[1].polygons = {box(12, 12, 40, 41)}; }),
                ElementsAre("The place 'Lawn' has another kind or outline since."));
    EXPECT_THAT(changesWith([](auto& places) { places.push_back(lawn("New", box(0, 0, 5, 5))); }), IsEmpty())
        << "what was measured is still right";
}

// The names of the keys order the cities of a place otherwise.
TEST(SavedAnswers, SunByPlaceOfSeveralScenariosComesBackInTheirOrder) {
    const Project project = town();
    SunByPlaceSettings settings;
    settings.study = question();
    settings.study.engine = StudySettings().engine;
    const NamedCity cities[]{
        {existingCity, *project.city}, {"Wide", *project.city}, {"Tower", cityOf(project, "Tower")->city}};
    NoProgress progress;
    const SunOfCities answer =
        compareSunByPlace(cities, {lawn("Lawn", box(12, 12, 40, 40))}, settings, progress, {}).value();
    SavedResult result = makeSavedResult(project, answer, keptAt);
    EXPECT_EQ(result.scenario, "Tower");
    result.scenario = "Renamed";
    const auto read = readSavedAnswer(result);
    ASSERT_TRUE(read) << read.error().text();
    const SunOfCities& back = std::any_cast<const SavedSunByPlace&>(read->content).sun;
    ASSERT_EQ(back.compared.size(), 2U);
    EXPECT_EQ(back.compared[0].sun.name, "Wide");
    EXPECT_EQ(back.compared[0].changes[0].meanHours, 0);
    EXPECT_EQ(back.compared[1].sun.name, "Renamed");
    EXPECT_NEAR(back.compared[1].changes[0].meanHours, answer.compared[1].changes[0].meanHours, 1e-4);
}

// As where a scenario plants the first trees.
TEST(SavedAnswers, SunByPlaceComesBackWithTheTreesOfTheScenarioAlone) {
    SunOfCities answer = sunny(town());
    ComparedSun& planted = answer.compared[0];
    planted.sun.withTrees = {{TreeColumns::seasonal, planted.sun.sun}};
    planted.sun.withTrees[0].sun[0].meanHours = 1.25;
    planted.changesWithTrees = computeChangesWithTrees(answer.baseline, planted.sun);
    const auto read = readSavedAnswer(makeSavedResult(town(), answer, keptAt));
    ASSERT_TRUE(read) << read.error().text();
    const SunOfCities& back = std::any_cast<const SavedSunByPlace&>(read->content).sun;
    EXPECT_THAT(back.baseline.withTrees, IsEmpty());
    ASSERT_EQ(back.compared[0].sun.withTrees.size(), 1U);
    EXPECT_EQ(back.compared[0].sun.withTrees[0].column, TreeColumns::seasonal);
    EXPECT_EQ(back.compared[0].sun.withTrees[0].sun[0].meanHours, 1.25);
    ASSERT_EQ(back.compared[0].changesWithTrees.size(), 1U);
    EXPECT_NEAR(back.compared[0].changesWithTrees[0][0].meanHours, 1.25 - answer.baseline.sun[0].meanHours,
                1e-4);
}

TEST(SavedAnswers, SunByPlaceOfAnotherShapeIsAnError) {
    SavedResult result = makeSavedResult(town(), sunny(town()), keptAt);
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(result.settings);
    json["kept"]["places"].erase(1);
    result.settings = json.dump();
    EXPECT_FALSE(readSavedAnswer(result));
    json["kept"].erase("places");
    result.settings = json.dump();
    EXPECT_FALSE(readSavedAnswer(result));
}

TEST(SavedAnswers, WhatChangedSinceIsReported) {
    const Project project = addResult(town(), "Tower", compared(town()), keptAt);
    const SavedResult& result = *project.results[0];
    const SavedOrigin origin = readSavedAnswer(result)->origin;
    Project higher = project;
    higher.scenarios[0].edits.emplace_back(ChangeHeight{"t", 41});
    EXPECT_THAT(findChangesSince(result, origin, higher),
                ElementsAre(HasSubstr("'Tower' has changed since")));
    Project demolished = project;
    City city = *project.city;
    city.buildings.pop_back();
    demolished.city = std::make_shared<const City>(city);
    EXPECT_EQ(findChangesSince(result, origin, demolished).size(), 2U)
        << "the scenario and what it starts from";
    Project removed = project;
    removed.scenarios.clear();
    EXPECT_THAT(findChangesSince(result, origin, removed),
                ElementsAre(HasSubstr("scenario 'Tower' no longer exists")));
    Project other = project;
    other.inputs[0].sha256 = "cd";
    EXPECT_THAT(findChangesSince(result, origin, other), ElementsAre(HasSubstr("other files")));
    Project named = project;
    named.lots.push_back({"new", box(0, 0, 5, 5)});
    EXPECT_THAT(findChangesSince(result, origin, named), IsEmpty()) << "lots shade nothing";
}

TEST(SavedAnswers, AScoreIsOutOfDateWhenItsWeightsAre) {
    const Project project = addResult(town(), "Score", scored(town()), keptAt);
    const SavedOrigin origin = readSavedAnswer(*project.results[0])->origin;
    Project other = project;
    other.weights[0].intervals[5].weight = 0.25;
    EXPECT_THAT(findWeightChangesSince(origin, other), ElementsAre(HasSubstr("'default' has changed since")));
    EXPECT_THAT(findChangesSince(*project.results[0], origin, other), IsEmpty()) << "the city is the same";
    other = project;
    other.weights[0].name = "months";
    EXPECT_THAT(findWeightChangesSince(origin, other), IsEmpty()) << "under another name";
    other.weights[0].intervals.pop_back();
    EXPECT_THAT(findWeightChangesSince(origin, other),
                ElementsAre(HasSubstr("weight table 'default' no longer exists")));
}

TEST(SavedAnswers, CellsThatChangedOutsideOfTheGridAreAnError) {
    SavedResult result = *addResult(town(), "Tower", compared(town()), keptAt).results[0];
    auto json = nlohmann::ordered_json::parse(result.settings);
    using Cells = nlohmann::ordered_json;
    const auto withCells = [&](const Cells& cells) {
        json["kept"]["changed_cells"] = cells;
        result.settings = json.dump();
        return readSavedAnswer(result);
    };
    EXPECT_TRUE(withCells(Cells::array({Cells::array({0, result.grid.size(), "ground"})})));
    EXPECT_FALSE(withCells(Cells::array({Cells::array({1, result.grid.size(), "ground"})})));
    EXPECT_FALSE(withCells(Cells::array({Cells::array({result.grid.size() + 1, 0, "ground"})})));
    EXPECT_FALSE(withCells(Cells::array({Cells::array({0, -1, "ground"})})));
    EXPECT_FALSE(withCells(Cells::array({Cells::array({0, 1, "water"})})));
    EXPECT_FALSE(withCells(Cells::array({5})));
    json["kept"].erase("changed_cells");
    result.settings = json.dump();
    const auto older = std::any_cast<SavedImpact>(readSavedAnswer(result)->content);
    EXPECT_EQ(std::ranges::count(older.impact.change, CellChange::none), std::ptrdiff_t(result.grid.size()));
}

TEST(SavedAnswers, SettingsOfAnotherShapeAreAnError) {
    SavedResult result = *addResult(town(), "June", existingCity, studied(town()), keptAt).results[0];
    SavedResult broken = result;
    broken.settings = "{";
    EXPECT_THAT(readSavedAnswer(broken).error().text(), HasSubstr("June: The saved result cannot be shown"));
    broken.settings = R"({"engine": "ray"})";
    EXPECT_FALSE(readSavedAnswer(broken));
    broken = result;
    broken.layers.pop_back();
    EXPECT_THAT(readSavedAnswer(broken).error().what, HasSubstr("a layer is missing"));
    broken = result;
    broken.layers[0].values.pop_back();
    EXPECT_THAT(readSavedAnswer(broken).error().what, HasSubstr("another size"));
    broken = result;
    broken.kind = "dream";
    EXPECT_THAT(readSavedAnswer(broken).error().advice, HasSubstr("newer Noonmark"));
}

TEST(SavedAnswers, AResultWithoutAHashSaysThatChangesAreNotKnown) {
    SavedResult result = *addResult(town(), "June", existingCity, studied(town()), keptAt).results[0];
    auto json = nlohmann::ordered_json::parse(result.settings);
    json.erase("kept");
    result.settings = json.dump();
    const SavedAnswer saved = readSavedAnswer(result).value();
    EXPECT_EQ(saved.origin.at, "");
    EXPECT_THAT(findChangesSince(result, saved.origin, town()), ElementsAre(HasSubstr("not known")));
}

TEST(SavedAnswers, AStudyKeepsItsMonthsAndWhatBuildingsTake) {
    const Project project = town();
    StudySettings settings = question();
    settings.engine = "horizon";
    settings.byMonth = settings.contributions = true;
    settings.period.start = 2026y / May / 31;
    NoProgress progress;
    const Study study = runStudy(*project.city, settings, progress, {}).value();
    const auto answer = readSavedAnswer(makeSavedResult(project, existingCity, study, keptAt)).value();
    const auto& saved = std::any_cast<const SavedStudy&>(answer.content);
    const std::vector<MonthShadow> months = monthsOf(*study.breakdown);
    ASSERT_EQ(saved.months.size(), 2U);
    EXPECT_EQ(saved.months[1].month, "2026-06");
    EXPECT_NEAR(saved.months[1].meanMinutes, months[1].meanMinutes, 0.005);
    const Bars now = makeMonthBars(study), then = makeMonthBars(saved.months, saved.start, saved.field.days);
    ASSERT_EQ(then.groups.size(), now.groups.size());
    for (std::size_t i = 0; i < now.groups.size(); ++i)
        EXPECT_NEAR(then.groups[i].values[0], now.groups[i].values[0], 0.001);
    const auto rows = listContributions(study.city, *study.breakdown, study.sun.dayCount());
    ASSERT_TRUE(saved.contributions);
    ASSERT_EQ(saved.contributions->size(), rows.size());
    EXPECT_EQ(saved.contributions->front().id, rows.front().id);
    EXPECT_NEAR(saved.contributions->front().attributedMin, rows.front().attributedMin, 0.0001);
}

TEST(SavedAnswers, OutdatedResultsAreFoundWithoutReadingTheirMaps) {
    Project project = town();
    const Project before = addResult(project, "June", existingCity, studied(project), keptAt);
    auto results = before.results;
    EXPECT_TRUE(findOutdated(results, before, {}).value().empty());
    auto broken = std::make_shared<SavedResult>(*results[0]);
    broken->name = "Broken";
    broken->settings = "{}";
    results.push_back(broken);
    project.city = std::make_shared<const City>();
    EXPECT_EQ(findOutdated(results, project, {}).value(), (std::set<std::string>{"Broken", "June"}));
    EXPECT_EQ(findOutdated(results, before, {}).value(), (std::set<std::string>{"Broken"}));
}

}  // namespace
}  // namespace noonmark::tests
