#include "core/review/rule/rule_days.h"

#include <gmock/gmock.h>

#include "tests/core/review/paper_days.h"

namespace noonmark {

namespace {

RuleSite momentSite(double lon, double lat, const std::string& zone) {
    RuleSite site;
    site.observer.place = {lon, lat};
    site.zone = zone;
    return site;
}

const RuleSite manhattan = momentSite(-73.98, 40.75, "America/New_York");

std::vector<std::string> clocksOn(const std::vector<RuleMoment>& moments, unsigned month) {
    std::vector<std::string> clocks;
    for (const RuleMoment& moment : moments)
        if (unsigned(moment.day.month()) == month) clocks.push_back(moment.clock);
    return clocks;
}

TEST(RuleMoments, AreTheTimesOfTheRulesDiagrams) {
    Rule rule = shippedRule("own", {});
    rule.deliverables.diagrams = RuleDiagrams{.timesMin = {9 * 60, 12 * 60 + 30, 23 * 60}};
    const auto moments = computeRuleMoments(rule, manhattan).value();
    ASSERT_FALSE(moments.empty());
    // The sun is down at 23:00.
    EXPECT_THAT(clocksOn(moments, unsigned(moments.front().day.month())),
                testing::ElementsAre("09:00", "12:30"));
    for (const RuleMoment& moment : moments) EXPECT_GT(moment.sun.direction.z, 0);
}

TEST(RuleMoments, WithoutTimesAreTheFullHoursOfItsHours) {
    Rule rule = shippedRule("ceqr", {});
    rule.deliverables.diagrams.reset();
    // CEQR's hours on 21 March: 07:36 to 16:29 on its clock.
    EXPECT_THAT(clocksOn(computeRuleMoments(rule, manhattan).value(), 3),
                testing::ElementsAre("08:00", "09:00", "10:00", "11:00", "12:00", "13:00", "14:00", "15:00",
                                     "16:00"));
    // At most some three a day, noon among them: every third of eight hours.
    const auto few = computeRuleMoments(rule, manhattan, {.maxHoursADay = 3}).value();
    EXPECT_THAT(clocksOn(few, 3), testing::ElementsAre("09:00", "12:00", "15:00"));
}

TEST(RuleMoments, OfARangeOfDaysAreThoseOfPlannersAndOneMore) {
    const Rule rule = shippedRule("san-francisco-295", {});
    using namespace std::chrono;
    const auto moments = computeRuleMoments(rule, momentSite(-122.42, 37.78, "America/Los_Angeles"),
                                            {.moreDays = {February / 3}, .maxHoursADay = 2})
                             .value();
    std::set<std::string> days;
    for (const RuleMoment& moment : moments) days.insert(formatText(moment.day).substr(5));
    EXPECT_THAT(days, testing::IsSupersetOf({"02-03", "03-21", "06-21"}));
    EXPECT_LE(days.size(), 5U);
}

}  // namespace

}  // namespace noonmark
