#include "app/gui/docks/scenarios/latest_answers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/gui/session/project/view_state.h"
#include "core/study/provenance/study_hash.h"
#include "scenarios/project/results/save_result.h"
#include "tests/gui/small_project.h"

namespace noonmark {
namespace {

using test::smallProject;

StudySettings quickQuestion(const Project& project) {
    StudySettings settings;
    settings.region = project.regions[0];
    settings.receivers.cellM = 4;
    settings.period.stepMinutes = 30;
    return settings;
}

SavedFigures savedStudy(const Project& project, const StudySettings& settings) {
    NoProgress progress;
    const auto study = runStudy(*project.city, settings, progress, {});
    EXPECT_TRUE(study);
    const auto figures = readSavedFigures(makeSavedResult(project, existingCity, *study), project);
    EXPECT_TRUE(figures);
    return figures.value_or(SavedFigures());
}

bool fits(const SavedFigures& saved, const StudySettings& settings) {
    return haveSettings(saved, settings, listHashes(settings));
}

TEST(ReadSavedFigures, ASavedStudyGivesWhatItMeasured) {
    const Project project = smallProject();
    const StudySettings settings = quickQuestion(project);
    const SavedFigures saved = savedStudy(project, settings);
    ASSERT_TRUE(saved.measured);
    EXPECT_GT(saved.measured->shadowAreaM2, 0);
    EXPECT_TRUE(fits(saved, settings));
}

TEST(ReadSavedFigures, EverySettingThatFiguresDependOnCounts) {
    const Project project = smallProject();
    const StudySettings settings = quickQuestion(project);
    const SavedFigures saved = savedStudy(project, settings);
    const auto fitsWith = [&](auto change) {
        StudySettings other = settings;
        change(other);
        return fits(saved, other);
    };
    EXPECT_FALSE(fitsWith([](StudySettings& s) { s.pressureHPa = 850; }));
    EXPECT_FALSE(fitsWith([](StudySettings& s) { s.temperatureC = 30; }));
    EXPECT_FALSE(fitsWith([](StudySettings& s) { s.period.refraction = false; }));
    EXPECT_FALSE(fitsWith([](StudySettings& s) { s.period.start += std::chrono::years(1); }));
    EXPECT_FALSE(fitsWith([](StudySettings& s) { s.engine = "ray"; }));
    // The same corners, and so the same grid, under the same name.
    EXPECT_FALSE(fitsWith([](StudySettings& s) {
        s.region.polygons = {{{{-80, -80}, {80, -80}, {80, 80}}, {}},
                             {{{-80, 60}, {-60, 80}, {-80, 80}}, {}}};
    })) << "a region that was drawn again";
    EXPECT_TRUE(fitsWith([](StudySettings& s) { s.region.name = "Renamed"; }));
    EXPECT_TRUE(fitsWith([](StudySettings& s) { s.memoryLimit = 1 << 30; }));
}

// Reading a project repairs outlines; the question stays the same.
TEST(SavedFigures, TheirQuestionIsTheSameAfterTheProjectWasClosed) {
    const Frame frame(LonLat{-73.98, 40.75}, 0);
    std::vector<Region> regions{makeRegionFromLonLatBox(frame, -73.99, 40.74, -73.95, 40.78).value(),
                                {"drawn",
                                 {{{{0, 0}, {10, 0}, {20, 0}, {20.1F, 33.3F}, {20.1F, 33.3F}, {-7, 12}},
                                   {{{1, 1}, {1, 3}, {3, 3}}}}}},
                                {"crossed", {{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {}}}},
                                {"turned", {{{{0, 10}, {10, 10}, {10, 0}, {0, 0}}, {}}}}};
    for (const Region& region : regions) {
        StudySettings settings;
        settings.region = region;
        settings.pressureHPa = 850;
        const auto texts = textsOf(ViewState{.study = settings});
        const auto again = parseViewState(texts).study;
        ASSERT_TRUE(again) << region.name;
        EXPECT_EQ(hashQuestion(*again), hashQuestion(settings)) << region.name;
        EXPECT_EQ(hashQuestion(*parseViewState(textsOf(ViewState{.study = again})).study),
                  hashQuestion(settings));
    }
}

TEST(SavedFigures, ComeBackFromTheProjectsView) {
    const Project project = smallProject();
    const StudySettings settings = quickQuestion(project);
    SavedFigures measured = savedStudy(project, settings);
    ImpactFigures impact;
    impact.gross = {1, 2, 3, 4, 5.5, 6, 7};
    impact.continuous.meanMin = std::nan("");
    impact.shadowAreaChangeM2 = -12.25;
    SunOfPlace sun;
    sun.meanHours = 4.25;
    sun.monthHours = {1.5, std::nan("")};
    const std::vector<ViewFigures> before{
        {"aa", "", {.question = "q", .measured = measured.measured}},
        {"bb", "cc", {.question = "q", .impact = impact}},
        {"dd", "", {.question = "q", .weights = project.weights.front(), .score = {0.125, 2.5}}},
        {"ee", "", {.question = "q", .sun = ScenarioSun{3, 2.5, {"2026-01", "2026-02"}, sun}}}};
    const auto after = parseViewFigures(formatText(before));
    ASSERT_EQ(after.size(), 4U);
    EXPECT_EQ(after[0].citySha256, "aa");
    EXPECT_EQ(after[0].figures.measured->shadowAreaM2, measured.measured->shadowAreaM2);
    EXPECT_EQ(after[1].baselineSha256, "cc");
    EXPECT_EQ(after[1].figures.impact->shadowAreaChangeM2, -12.25);
    EXPECT_EQ(after[1].figures.impact->gross.maxLessShadowMin, 7);
    EXPECT_TRUE(std::isnan(after[1].figures.impact->continuous.meanMin));
    EXPECT_EQ(after[2].figures.weights, project.weights.front());
    EXPECT_EQ(after[2].figures.score.scoreM2, 0.125);
    EXPECT_FALSE(after[2].figures.measured);
    ASSERT_TRUE(after[3].figures.sun);
    EXPECT_EQ(after[3].figures.sun->places, 3U);
    EXPECT_EQ(after[3].figures.sun->enoughHours, 2.5);
    EXPECT_EQ(after[3].figures.sun->mean.meanHours, 4.25);
    EXPECT_TRUE(std::isnan(after[3].figures.sun->mean.enoughShare));
    EXPECT_EQ(after[3].figures.sun->months.at(1), "2026-02");
    EXPECT_EQ(after[3].figures.sun->mean.monthHours.at(0), 1.5);
    EXPECT_TRUE(std::isnan(after[3].figures.sun->mean.monthHours.at(1)));
}

TEST(SavedFigures, OfAStrangersViewAreReadAsFarAsTheyAreValid) {
    for (const char* text :
         {"", "{", "[]", "{}", "[1, null, {}]", R"([{"city_sha256": 1, "question_sha256": 2}])",
          R"([{"city_sha256": "a", "question_sha256": "q", "measured": []}])",
          R"([{"city_sha256": "a", "question_sha256": "q", "sun": {"places": 1, "enough_hours": 2,
               "months": {"20": 1}}}])",
          R"([{"city_sha256": "a", "question_sha256": "q", "score": {"table": "t"}}])"})
        EXPECT_TRUE(parseViewFigures(text).empty()) << text;
}

}  // namespace
}  // namespace noonmark
