#include "core/review/library/read_rule.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/review/library/rule_library.h"
#include "core/review/rule/rule_names.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {

namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string ownText() { return RuleLibrary::load().value().textOf("own").value(); }

/// The shipped rule `own` with one text replaced.
std::string changed(const std::string& from, const std::string& to) {
    std::string text = ownText();
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string errorOf(const std::string& text) {
    const auto rule = parseRule(text, "mine.json");
    return rule ? "" : rule.error().text();
}

TEST(RuleLibrary, EveryShippedRuleIsValidWithEveryChoice) {
    const auto library = RuleLibrary::load();
    ASSERT_TRUE(library);
    for (const Warning& warning : library->warnings()) ADD_FAILURE() << warning.where << ": " << warning.what;
    EXPECT_FALSE(library->rules().empty());
    for (const Rule& rule : library->rules())
        for (const auto& [choice, options] : rule.choices)
            for (const std::string& option : options) {
                const auto read = library->find(rule.key, {{choice, option}});
                EXPECT_TRUE(read) << rule.key << ": " << read.error().text();
            }
}

TEST(RuleLibrary, EveryShippedRuleSaysWhatItDoesNotCheck) {
    const auto library = RuleLibrary::load();
    for (const Rule& rule : library->rules()) {
        EXPECT_FALSE(rule.notChecked.empty()) << rule.key;
        EXPECT_EQ(rule.deliverables.columns.empty(), rule.receivers.surface == RuleSurface::windows)
            << rule.key << ": the table of windows has columns of its own";
        EXPECT_FALSE(rule.window.evidence.source.empty()) << rule.key;
    }
}

TEST(RuleLibrary, EveryShippedRuleSaysWhichTreesItCounts) {
    const auto library = RuleLibrary::load().value();
    for (const Rule& rule : library.rules()) {
        const bool isOfBre = rule.key.starts_with("bre-209");
        EXPECT_EQ(rule.occluders.trees != RuleTrees::without, isOfBre) << rule.key;
        EXPECT_FALSE(rule.occluders.treesEvidence.source.empty()) << rule.key;
        EXPECT_THAT(library.textOf(rule.key).value(), HasSubstr("\"trees\"")) << rule.key << " is silent";
    }
    const Rule windows = library.find("bre-209-windows").value();
    EXPECT_EQ(windows.occluders.trees, RuleTrees::evergreens);
    EXPECT_EQ(windows.occluders.treesEvidence.status, FigureStatus::reported);
    EXPECT_EQ(library.find("bre-209-windows", {{"windows of", "own scheme"}}).value().occluders.trees,
              RuleTrees::existingAndEvergreens);
    EXPECT_EQ(library.find("bre-209-amenity").value().occluders.trees, RuleTrees::evergreenBelts);
}

TEST(ReadRule, TreesAreANameOrTrueOrFalse) {
    const auto treesOf = [](const std::string& text) {
        return parseRule(changed("\"trees\": \"without\"", "\"trees\": " + text), "mine.json")
            .value()
            .occluders.trees;
    };
    EXPECT_EQ(treesOf("false"), RuleTrees::without);
    EXPECT_EQ(treesOf("true"), RuleTrees::seasonal);
    EXPECT_EQ(treesOf("\"as evergreens\""), RuleTrees::asEvergreens);
    EXPECT_EQ(treesOf(R"({"count": "evergreens", "status": "R"})"), RuleTrees::evergreens);
    EXPECT_THAT(errorOf(changed("\"trees\": \"without\"", "\"trees\": \"oaks\"")),
                AllOf(HasSubstr("occluders.trees"), HasSubstr("'oaks' is not known")));
    EXPECT_THAT(errorOf(changed("\"trees\": \"without\"", "\"trees\": 3")), HasSubstr("occluders.trees"));
}

TEST(ReadRule, NoTreesShadeAPlaneAboveTheGround) {
    std::string text = changed("\"trees\": \"without\"", "\"trees\": \"seasonal\"");
    const std::string ground = "\"surface\": \"ground\"";
    text.replace(text.find(ground), ground.size(), "\"surface\": \"plane\", \"plane_m\": 4");
    EXPECT_THAT(errorOf(text),
                AllOf(HasSubstr("occluders.trees"), HasSubstr("on the ground and at windows")));
}

TEST(RuleLibrary, NamesSimilarRules) {
    const auto library = RuleLibrary::load();
    const auto rule = library->find("ceqrr");
    ASSERT_FALSE(rule);
    EXPECT_THAT(rule.error().text(), AllOf(HasSubstr("no rule 'ceqrr'"), HasSubstr("'ceqr'")));
}

TEST(RuleLibrary, ReadsFoldersAndLeavesOutBadFilesWithAWarning) {
    const noonmark::tests::TemporaryFolder folder;
    std::ofstream(folder.path("good.json")) << changed("\"key\": \"own\"", "\"key\": \"garden\"");
    std::ofstream(folder.path("taken.json")) << ownText();
    std::ofstream(folder.path("broken.json")) << "{";
    std::ofstream(folder.path("notes.txt")) << "no rule";
    const auto library = RuleLibrary::load({folder.path("")});
    ASSERT_TRUE(library) << library.error().text();
    EXPECT_EQ(library->rules().size(), RuleLibrary::load().value().rules().size() + 1);
    EXPECT_EQ(library->warnings().size(), 2);
    const auto garden = library->find("garden");
    ASSERT_TRUE(garden);
    EXPECT_THAT(garden->file, HasSubstr("good.json"));
    EXPECT_FALSE(RuleLibrary::load({folder.path("nowhere")}));
}

TEST(ReadRule, StatesFileAndFieldOfWhatIsWrong) {
    struct Case {
        std::string from, to, where;
    };
    for (const Case& wrong : {
             Case{"\"schema\": 1", "\"schema\": 2", "schema"},
             {"\"key\": \"own\"", "\"key\": \"../own\"", "key"},
             {"\"name\": \"A rule of your own\"", "\"name\": \"\"", "name"},
             {"\"name\": \"A rule of your own\"", "\"name\": \"a\\u001b[31mb\"", "name"},
             {"\"name\": \"A rule of your own\"", "\"name\": 3", "name"},
             {"03-21", "02-30", "days.on[0]"},
             {"03-21", "06-21", "days.on"},
             {"09:00", "16:00", "window.hours"},
             {"09:00", "9 am", "window"},
             {"\"civil\"", "\"summer\"", "clock.kind"},
             {"\"civil\"", "\"fixed\"", "clock.utc_offset_h"},
             {"\"step_min\": 1", "\"step_min\": 0", "sampling.step_min"},
             {"\"step_min\": 1", "\"step_min\": \"1\"", "sampling.step_min"},
             {"\"step_min\": 1", "\"step_mn\": 1", "sampling.step_min"},
             {"\"ground\"", "\"plane\"", "receivers.plane_m"},
             {"\"ground\"",
              "\"ground\", \"road_shift\": {\"narrow_m\": 10, \"share\": 0.5, \"far_side_m\": 5}",
              "receivers.road_shift"},
             {"\"ground\"",
              "\"ground\", \"lines_m\": {\"inner\": 5, \"outer\": 10}, \"road_shift\": {\"narrow_m\": 4, "
              "\"share\": 0.5, \"far_side_m\": 5}",
              "receivers.road_shift.far_side_m"},
             {"\"terrain\": true", "\"terrain\": 1", "occluders.terrain"},
             {"\"spot total\"", "\"share\"", "criteria.new-shadow.spot"},
             {"\"value\": 60", "\"value\": -1", "criteria.new-shadow.limit.value"},
             {"\"value\": 60", "\"former_ratio\": 0.8", "criteria.new-shadow.limit"},
             {"\"new-shadow\"", "\"new shadow\"", "criteria"},
             {"\"enters\"", "\"entres\"", "deliverables.columns"},
             {"\"not_checked\"", "\"not_chekced\"", "not_chekced"},
             {"\"must\": \"every\"", "\"must\": \"some\"", "days.must"},
         }) {
        const std::string error = errorOf(changed(wrong.from, wrong.to));
        EXPECT_THAT(error, AllOf(HasSubstr("mine.json, "), HasSubstr(wrong.where))) << wrong.to;
        EXPECT_EQ(error.find('\x1b'), std::string::npos);
    }
}

TEST(ReadRule, SuggestsTheFieldThatWasMeant) {
    const std::string error = errorOf(changed("\"terrain\"", "\"terain\""));
    EXPECT_THAT(error, AllOf(HasSubstr("occluders.terain"), HasSubstr("'terrain'")));
}

TEST(ReadRule, RefusesHostileFiles) {
    EXPECT_THAT(errorOf(""), HasSubstr("not JSON"));
    EXPECT_THAT(errorOf("[]"), HasSubstr("one JSON object"));
    EXPECT_THAT(errorOf("{\"key\": NaN}"), HasSubstr("not JSON"));
    EXPECT_THAT(errorOf(changed("\"value\": 60", "\"value\": 1e999")), HasSubstr("not JSON"));
    EXPECT_THAT(errorOf("{\"key\": \"\xff\xfe\"}"), HasSubstr("not JSON"));
    EXPECT_THAT(errorOf(std::string(300'000, ' ')), HasSubstr("larger than 256 kB"));
    EXPECT_THAT(errorOf(std::string(100'000, '[')), HasSubstr("nested"));
    std::string deep;
    for (int i = 0; i < 20'000; ++i) deep += "{\"a\":";
    EXPECT_THAT(errorOf(deep), HasSubstr("nested"));
    EXPECT_THAT(errorOf(changed("\"schema\": 1", "\"schema\": 1, \"schema\": 1")), HasSubstr("twice"));
    std::string many = "\"on\": [";
    for (int i = 0; i < 500; ++i) many += "\"03-21\", ";
    EXPECT_THAT(errorOf(changed("\"on\": [", many)), HasSubstr("days.on"));
    EXPECT_THAT(errorOf(changed("\"key\"", "\"a\\u0007b\": 1, \"key\"")), HasSubstr("a?b"));
}

TEST(ReadRule, AFileCutOffAnywhereIsRefused) {
    const std::string text = ownText();
    const std::size_t end = text.rfind('}');
    for (std::size_t length = 0; length < end; length += 7)
        EXPECT_FALSE(parseRule(text.substr(0, length), "cut"));
}

TEST(ReadRule, AppliesTheChosenOptionAndRefusesOthers) {
    const auto library = RuleLibrary::load();
    const auto rule = library->find("japan", {{"plane", "6.5 m"}});
    ASSERT_TRUE(rule);
    EXPECT_EQ(rule->receivers.planeM, 6.5);
    EXPECT_EQ(rule->chosen.at("limits"), "3 h, 2 h");
    EXPECT_THAT(library->find("japan", {{"plane", "2 m"}}).error().text(), HasSubstr("no option '2 m'"));
    EXPECT_THAT(library->find("japan", {{"colour", "red"}}).error().text(), HasSubstr("no choice 'colour'"));
}

TEST(RuleTimes, ReadsAndWritesBounds) {
    for (const std::string text : {"09:18", "24:00", "sunrise", "sunrise+1.5h", "sunset-1h", "sunrise-20m"}) {
        const auto bound = parseHoursBound(text);
        ASSERT_TRUE(bound) << text;
        EXPECT_EQ(formatText(*bound), text);
    }
    for (const std::string text : {"", "9:18", "25:00", "sunrise+", "sunrise+h", "sunrise+13h",
                                   "sunrise+nanh", "noon", "sunset-1e99h", "sunrise+1.5"})
        EXPECT_FALSE(parseHoursBound(text)) << text;
    for (const std::string text : {"3-21", "13-01", "00-10", "02-30", "ab-cd", "03-21x", ""})
        EXPECT_FALSE(parseRuleDay(text)) << text;
    EXPECT_TRUE(parseRuleDay("02-29"));
}

}  // namespace

}  // namespace noonmark
