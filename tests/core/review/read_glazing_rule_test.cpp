#include <gmock/gmock.h>

#include "core/review/library/rule_library.h"
#include "core/review/library/rule_text.h"

namespace noonmark {

namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string errorOfChanged(const std::string& key, const std::string& from, const std::string& to) {
    std::string text = RuleLibrary::load().value().textOf(key).value();
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    const auto rule = parseRule(text.replace(at, from.size(), to), "mine.json");
    return rule ? "" : rule.error().text();
}

TEST(ReadGlazingRule, StatesFileAndFieldOfWhatIsWrong) {
    struct Case {
        std::string key, from, to, where;
    };
    for (const Case& wrong : {
             Case{"korea", "\"mid pane\"", "\"middle\"", "receivers.point.at"},
             {"korea", "\"outside\"", "\"front\"", "receivers.point.face"},
             {"korea", "\"face\": \"outside\"", "\"above_sill_m\": 0.3", "receivers.point.at"},
             {"tno-light", "\"above_floor_m\": 0.75", "\"above_floor_m\": 11", "above_floor_m"},
             {"tno-light", "\"above_floor_m\": 0.75", "\"above_floor\": 1", "receivers.point.above_floor"},
             {"korea", "\"point\"", "\"pint\"", "receivers.point"},
             {"korea", "\"width_m\": 1.5", "\"width_m\": 0", "receivers.opening.width_m"},
             {"korea", "\"wall_m\": 0.3", "\"wall_m\": \"thick\"", "receivers.opening.wall_m"},
             {"korea", "\"unit\": \"window\"", "\"unit\": \"house\"", "receivers.unit"},
             {"china-gb-50180", "\"least_deg\": 15", "\"least_deg\": 90", "receivers.sweep.least_deg"},
             {"china-gb-50180", "\"least_deg\": 15", "\"wall_over_width\": 1",
              "receivers.sweep.wall_over_width"},
             {"korea", "\"hours\": [\"09:00\", \"15:00\"]", "\"hours\": [\"15:00\", \"09:00\"]",
              "criteria.unbroken.hours"},
             {"korea", "\"hours\": [\"09:00\", \"15:00\"]", "\"hours\": [\"sunrise\", \"15:00\"]",
              "criteria.unbroken.hours"},
             {"korea", "[[\"total\"], [\"unbroken\"]]", "[[\"total\"], [\"longest\"]]", "holds_if[1]"},
             {"korea", "[[\"total\"], [\"unbroken\"]]", "[[\"total\"], []]", "holds_if[1]"},
             {"korea", "[[\"total\"], [\"unbroken\"]]", "[[\"total\"], 3]", "holds_if[1]"},
             {"korea", "[[\"total\"], [\"unbroken\"]]", "{}", "holds_if"},
             {"korea", "\"spot longest run\"", "\"largest area\"", "criteria.unbroken.measure"},
             {"korea", "\"quantity\": \"sun\"", "\"quantity\": \"shadow\"", "criteria.total.quantity"},
             {"korea", "\"surface\": \"windows\"", "\"surface\": \"ground\"", "receivers.point"},
             {"bre-209-windows", "\"facing\": [90, 270]", "\"facing\": [90, 400]", "criteria.annual.facing"},
             {"bre-209-windows", "\"facing\": [90, 270]", "\"facing\": [90]", "criteria.annual.facing"},
             {"bre-209-windows", "\"loss\": 4", "\"loss\": -4", "criteria.loss.limit.loss"},
             {"bre-209-windows", "\"unit\": \"window\"", "\"unit\": \"room\"", "criteria.vsc.measure"},
             {"bre-209-windows", "\"readings\"",
              "\"sunshine\": {\"by_month\": [0.5], \"status\": \"U\"}, \"readings\"", "sunshine.by_month"},
             {"bre-209-windows", "\"readings\"",
              "\"sunshine\": {\"by_month\": [2,1,1,1,1,1,1,1,1,1,1,1], \"status\": \"U\"}, \"readings\"",
              "sunshine.by_month"},
             {"bre-209-windows", "\"readings\"",
              "\"sunshine\": {\"by_month\": [0,0,0,0,0,0,0,0,0,0,0,0], \"status\": \"U\"}, \"readings\"",
              "sunshine.by_month"},
             {"nsw-adg", "\"criterion\": \"hours\"", "\"criterion\": \"minutes\"", "shares[0].criterion"},
             {"nsw-adg", "\"at_least\": 0.7", "\"at_least\": 70", "shares[0].at_least"},
             {"own", "\"spot total\"", "\"vsc\"", "criteria.new-shadow"},
             {"own", "\"measure\": \"spot total\"", "\"measure\": \"spot total\", \"facing\": [90, 270]",
              "criteria.new-shadow"},
             {"own", "\"not_checked\"", "\"holds_if\": [[\"new-shadow\"]], \"not_checked\"", "holds_if"},
             {"own", "\"value\": 60", "\"loss\": 60", "criteria.new-shadow.limit"},
         }) {
        const std::string error = errorOfChanged(wrong.key, wrong.from, wrong.to);
        EXPECT_THAT(error, AllOf(HasSubstr("mine.json, "), HasSubstr(wrong.where)))
            << wrong.key << ": " << wrong.to;
    }
}

TEST(ReadGlazingRule, DescribesWhatItRead) {
    const auto library = RuleLibrary::load().value();
    EXPECT_THAT(describeRule(library.find("china-gb-50180").value()),
                AllOf(HasSubstr("sill ends, outside face"), HasSubstr("at least 15 deg from the pane"),
                      HasSubstr("sill 0.9 m, wall 0.24 m")));
    EXPECT_THAT(
        describeRule(library.find("bre-209-windows", {{"face", "inside"}}).value()),
        AllOf(HasSubstr("mid pane, inside face"), HasSubstr("vsc and annual and winter"),
              HasSubstr("windows facing 90 to 270 deg"), HasSubstr("loss <= 4.0 %"), HasSubstr(">= 27.0 %")));
    EXPECT_THAT(describeRule(library.find("korea").value()), HasSubstr("09:00 to 15:00"));
    EXPECT_THAT(describeRule(library.find("nsw-adg").value()),
                AllOf(HasSubstr("hours for at least 70 %"), HasSubstr("by dwelling")));
}

}  // namespace

}  // namespace noonmark
