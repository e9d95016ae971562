#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/describe/command_options.h"
#include "core/describe/field_json.h"
#include "core/describe/field_values.h"
#include "core/io/settings/read_settings.h"
#include "core/measures/legend_choice.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/elements/element_fields.h"
#include "core/study/provenance/study_hash.h"
#include "core/study/review_study.h"
#include "core/study/study_fields.h"
#include "core/sun/period_fields.h"
#include "tests/shared/changed_fields.h"

namespace noonmark {
namespace {

using namespace tests;

// A member that is added needs a row in its table; then this number grows with it.
static_assert(countMembers<Period>() == 8);
static_assert(countMembers<ReceiverSettings>() == 2);
static_assert(countMembers<ErrorSampleSettings>() == 2);
static_assert(countMembers<StudySettings>() == 12);
static_assert(countMembers<ReadSettings>() == 23);
static_assert(countMembers<ElementSettings>() == 13);
static_assert(countMembers<SunByPlaceSettings>() == 5);
static_assert(countMembers<LegendChoice>() == 9);

TEST(SettingsFields, NoneOfAReviewIsForgotten) {
    const ReviewSettings standard{2, "Europe/Paris", 2026};
    for (const Field& field : reviewFields().rows()) {
        ReviewSettings changed = standard;
        ASSERT_TRUE(field.set(&changed, otherValue(field, field.get(&standard)))) << field.key;
        EXPECT_NE(questionText(reviewFields().of(changed)), questionText(reviewFields().of(standard)))
            << field.key;
        EXPECT_NE(listOptions(reviewFields().of(changed)), listOptions(reviewFields().of(standard)))
            << field.key;
    }
    EXPECT_EQ(namesOf(listOptions(reviewFields().of(ReviewSettings{1, "UTC", 2026}))),
              (std::set<std::string>{"--cell", "--year", "--zone"}))
        << "a command states the defaults too";
}

TEST(SettingsFields, NoneOfSunByPlaceIsForgotten) { expectNoticed(sunByPlaceFields(), SunByPlaceSettings{}); }

TEST(SettingsFields, NoneOfALegendIsForgotten) { expectNoticed(legendFields(), LegendChoice{}); }

TEST(SettingsFields, NoneOfAPeriodIsForgotten) {
    expectNoticed(periodFields(), Period{});
    Period bySun;
    bySun.window = SolarHours{std::chrono::minutes(30), std::chrono::minutes(0)};
    EXPECT_EQ(namesOf(listOptions(periodFields().of(bySun))),
              (std::set<std::string>{"--start", "--days", "--window", "--step", "--zone"}));
    bySun.window->rule = SunriseRule::centre;
    Period back;
    ASSERT_TRUE(readFieldsJson(periodFields().of(back), fieldsJson(periodFields().of(bySun))));
    EXPECT_EQ(back, bySun);
}

TEST(SettingsFields, NoneOfReadingIsForgotten) {
    ReadSettings standard;
    for (const Field& field : readSettingsFields().rows()) {
        ReadSettings changed;
        ASSERT_TRUE(field.set(&changed, otherValue(field, field.standard))) << field.key;
        const auto back = readSettingsFrom(formatText(changed));
        ASSERT_TRUE(back) << field.key;
        EXPECT_EQ(field.get(&*back), field.get(&changed)) << field.key << ": projects lose it";
        EXPECT_EQ(namesOf(listOptions(readSettingsFields().of(changed))),
                  (std::set<std::string>{std::string(field.flag)}));
    }
}

TEST(SettingsFields, NoneOfAStudyIsForgotten) {
    expectNoticed(studyFields(), StudySettings{});
    for (const Field& field : studyFields().rows()) {
        StudySettings changed;
        if (!Described(studyFields().of(changed)).applies(field)) continue;
        ASSERT_TRUE(field.set(&changed, otherValue(field, field.standard)));
        EXPECT_EQ(hashQuestion(changed) != hashQuestion({}), field.role == SettingRole::question)
            << field.key;
        EXPECT_EQ(hashSettings(changed) != hashSettings({}), field.role != SettingRole::none) << field.key;
    }
}

TEST(SettingsFields, NoneOfPointsIsForgotten) {
    for (const auto& choice : elementPlaceChoices) {
        ElementSettings standard;
        standard.places = choice.value;
        standard.faces.place = "Park";
        expectNoticed(elementFields(), standard);
    }
}

// Hashes that stand in projects of earlier versions.
TEST(QuestionHash, OfAnEarlierVersionStaysCurrent) {
    StudySettings settings;
    settings.period.zone = "America/New_York";
    settings.region.polygons.push_back({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}});
    const QuestionHashes hashes = listHashes(settings);
    EXPECT_EQ(hashes.version1, "f899ea8fcb3f0b17eba2ea3f53a2946e15abe65bd3802579336075006bd390fd");
    EXPECT_TRUE(hashes.matches(hashes.version1));
    EXPECT_TRUE(hashes.matches(hashQuestion(settings)));
    settings.temperatureC = 11;
    EXPECT_FALSE(listHashes(settings).matches(hashes.version1));
    EXPECT_FALSE(listHashes(settings).matches(hashes.current));
    EXPECT_TRUE(hashes.current.starts_with("2:"));
}

// The texts of periods and surfaces are part of the old hash: they cannot be reworded.
TEST(QuestionHash, OfAnEarlierVersionKnowsHoursOfTheSunRoofsAndOptions) {
    StudySettings settings;
    settings.period.zone = "Europe/Paris";
    settings.period.days = 365;
    settings.period.refraction = false;
    settings.period.window =
        SolarHours{std::chrono::minutes(90), std::chrono::minutes(75), SunriseRule::centre};
    settings.receivers = {2.5, ReceiverPlaces::roofs};
    settings.engine = "horizon";
    settings.engineSettings["bin"] = 0.5;
    settings.region.polygons.push_back({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}});
    EXPECT_EQ(listHashes(settings).version1,
              "5e2ac146beb833e9d4a45798e3e50d7f8610525546a6bce06f46178bdd55ad12");
}

TEST(SettingsFields, FacadesAndPointsOfACommandLineAreReadBackAsTheyAreStated) {
    ElementSettings facades{.places = ElementPlaces::facades, .proposed = true};
    const auto& words = facadesOfFields();
    ASSERT_EQ(listOptions(words.of(std::as_const(facades))),
              (std::vector<CommandOption>{{"--facades-of", {"proposed"}}}));
    const Field& row = words.rows().front();
    ASSERT_TRUE(words.of(facades).set(row, std::vector<std::string>{"A", "B"}));
    EXPECT_FALSE(facades.proposed);
    EXPECT_EQ(facades.buildings, (std::vector<std::string>{"A", "B"}));
    ASSERT_TRUE(words.of(facades).set(row, std::vector{std::string(allFacades)}));
    EXPECT_TRUE(facades.buildings.empty());

    ElementSettings points{.places = ElementPlaces::points};
    const std::vector<std::string> stated{"-73.98,40.75,1.5", "-73.97,40.76"};
    ASSERT_TRUE(pointFields().of(points).set(pointFields().rows().front(), stated));
    const auto options = listOptions(pointFields().of(std::as_const(points)));
    ASSERT_EQ(options.size(), 2);
    EXPECT_EQ(options[0].name, "--point");
    ElementSettings again{.places = ElementPlaces::points};
    ASSERT_TRUE(pointFields().of(again).set(pointFields().rows().front(),
                                            std::vector{options[0].values[0], options[1].values[0]}));
    EXPECT_EQ(again.points, points.points);
    EXPECT_FALSE(pointFields().of(again).set(pointFields().rows().front(), std::vector<std::string>{"1"}));
}

TEST(SettingsFields, AFlagMayDifferOnACommand) {
    Period period;
    period.from = std::chrono::minutes(14 * 60);
    const auto options = listOptions(periodFields().of(std::as_const(period)), periodFlagsBesideScenarios());
    EXPECT_TRUE(std::ranges::any_of(options, [](const auto& option) { return option.name == "--at"; }));
    EXPECT_FALSE(hasFlag(periodFields().rows(), "--at"));
    EXPECT_EQ(flagOf(periodFields().rows(), "step_min"), "--step");
}

TEST(SettingsFields, MessagesNameOptionsThatExist) {
    EXPECT_EQ(readOption("stand", "absolute"), "--stand absolute");
    for (const char* key : {"layer", "height_unit", "mesh_anchor", "mesh_north_deg", "up", "terrain_shows",
                            "heights_from_surface", "surface_tolerance_m", "levels_field", "height_field",
                            "terrain_from_bases", "extent", "crs"})
        EXPECT_TRUE(readOption(key).starts_with("--")) << key;
}

}  // namespace
}  // namespace noonmark
