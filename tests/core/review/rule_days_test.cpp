#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/review/rule/rule_days.h"
#include "tests/core/review/paper_days.h"

namespace noonmark {

namespace {

RuleSite siteAt(double lon, double lat, const std::string& zone, int year = 2026) {
    RuleSite site;
    site.observer.place = {lon, lat};
    site.zone = zone;
    site.year = year;
    return site;
}

const RuleSite newYork = siteAt(-73.98, 40.75, "America/New_York");
const RuleSite boston = siteAt(-71.066, 42.355, "America/New_York");
const RuleSite sanFrancisco = siteAt(-122.42, 37.78, "America/Los_Angeles");
const RuleSite sapporo = siteAt(141.35, 43.06, "Asia/Tokyo");

RuleSun sunOf(const std::string& key, const RuleSite& site, const RuleChoices& choices = {}) {
    auto made = computeRuleSun(shippedRule(key, choices), site);
    if (!made) throw std::runtime_error(made.error().text());
    return *std::move(made);
}

std::string utcOf(const RuleSun& sun, std::size_t step) {
    return Zone::utc().text(sun.sun.steps.at(step).at);
}

double sumOf(const std::vector<double>& weights) {
    double sum = 0;
    for (const double weight : weights) sum += weight;
    return sum;
}

TEST(RuleDays, AWinterOfTheOtherHalfOfTheEarthIsWarnedOf) {
    const RuleSite melbourne = siteAt(144.96, -37.81, "Australia/Melbourne");
    const RuleSite nairobi = siteAt(36.82, -1.29, "Africa/Nairobi");
    EXPECT_EQ(sunOf("bre-209-windows", newYork).warnings.size(), 0U);
    EXPECT_EQ(sunOf("bre-209-windows", melbourne).warnings.size(), 1U);
    EXPECT_EQ(sunOf("bre-209-windows", nairobi).warnings.size(), 0U) << "no winter";
    EXPECT_EQ(sunOf("melbourne-c278", melbourne).warnings.size(), 0U);
    EXPECT_EQ(sunOf("melbourne-c278", newYork).warnings.size(), 1U);
    EXPECT_EQ(sunOf("four-days", melbourne).warnings.size(), 0U) << "all seasons";
}

TEST(RuleDays, CeqrTakesItsExplicitHoursInStandardTime) {
    const RuleSun sun = sunOf("ceqr", newYork);
    ASSERT_EQ(sun.sun.days.size(), 4);
    // In time order: 21 March 7:36 to 16:29 is 533 minutes; standard time is UTC-5, also in summer.
    EXPECT_EQ(sun.sun.days[0].date, on(2026, 3, 21));
    EXPECT_EQ(sun.sun.days[0].count, 533);
    EXPECT_EQ(utcOf(sun, 0), "2026-03-21T12:36:00+00:00");
    EXPECT_EQ(sun.sun.days[1].count, 651);  // 6:27 to 17:18
    EXPECT_EQ(sun.sun.days[2].count, 724);  // 5:57 to 18:01
    EXPECT_EQ(utcOf(sun, sun.sun.days[2].first), "2026-06-21T10:57:00+00:00");
    EXPECT_EQ(sun.sun.days[3].count, 362);  // 8:51 to 14:53
    EXPECT_EQ(sun.clock.timeText(on(2026, 6, 21), sun.sun.steps[sun.sun.days[2].first].at), "05:57");
    EXPECT_EQ(sun.sun.stepMinutes, 1);
}

TEST(RuleDays, SanFranciscosYearHasTheHoursThatPracticeCounts) {
    // rules: 3,721.4 h reported, 3,720.9 h by our own count
    for (const std::string days : {"every day", "mirrored half year"}) {
        const RuleSun sun = sunOf("san-francisco-295", sanFrancisco, {{"days", days}});
        EXPECT_EQ(sumOf(sun.weights), 365) << days;
        double hours = 0;
        for (std::size_t i = 0; i < sun.weights.size(); ++i)
            hours += sun.weights[i] * sun.sun.days[i].count * sun.sun.stepMinutes / 60;
        EXPECT_NEAR(hours, 3720.9, days == "every day" ? 1 : 5) << days;
    }
}

TEST(RuleDays, WholeMinutesAreWhole) {
    // From sunrise to sunset days have no whole number of steps of 5 min: the mean is 4.99997 min, by which
    // 24 steps were 119.999 min, less than 2 h.
    const RuleSun sun = sunOf("russia-territory", siteAt(37.62, 55.75, "Europe/Moscow"));
    EXPECT_EQ(sun.sun.stepMinutes, 5);
    EXPECT_EQ(sunOf("san-francisco-295", sanFrancisco).sun.stepMinutes, 15);
    EXPECT_EQ(sunOf("estonia", siteAt(24.75, 59.44, "Europe/Tallinn")).sun.stepMinutes, 1);
}

TEST(RuleDays, AMirroredYearRunsFromOneSolsticeToTheOther) {
    for (const int year : {2026, 2028}) {
        RuleDays days;
        days.first = std::chrono::January / 1;
        days.last = std::chrono::December / 31;
        days.mirrored = true;
        const auto dates = datesOf(days, year);
        ASSERT_TRUE(dates);
        double sum = 0;
        for (const auto& [date, weight] : *dates) sum += weight;
        EXPECT_EQ(sum, year == 2028 ? 366 : 365);
        EXPECT_EQ(dates->front().first, on(year, 6, 21));
        EXPECT_EQ(dates->front().second, 1);
        EXPECT_EQ(dates->at(1).second, 2);
        EXPECT_EQ(dates->back().first, on(year, 12, year == 2028 ? 21 : 20));
    }
}

TEST(RuleDays, ARangeMaySpanNewYearAndSkipDays) {
    RuleDays days;
    days.first = std::chrono::December / 30;
    days.last = std::chrono::January / 8;
    days.everyDays = 4;
    const auto dates = datesOf(days, 2026);
    ASSERT_TRUE(dates);
    ASSERT_EQ(dates->size(), 3);  // 30 December, 3 and 7 January stand for 4, 4 and 2 days
    EXPECT_EQ(dates->at(1).first, on(2027, 1, 3));
    EXPECT_EQ(dates->at(2).second, 2);
}

TEST(RuleDays, TheLeapDayNeedsALeapYear) {
    RuleDays days;
    days.fixed.push_back({std::chrono::February / 29, {}, {}, {}});
    EXPECT_TRUE(datesOf(days, 2028));
    EXPECT_FALSE(datesOf(days, 2026));
}

TEST(RuleDays, BostonsHoursBeginAfterTheLaterOfSunriseAndSeven) {
    const RuleSun sun = sunOf("boston-common", boston);
    ASSERT_EQ(sun.sun.days.size(), 365);
    const auto begins = [&](CivilDate date) {
        const auto day = std::ranges::find(sun.sun.days, date, &SunDay::date);
        return sun.clock.minutesOf(date, sun.sun.steps.at(day->first).at);
    };
    EXPECT_NEAR(begins(on(2026, 6, 21)), 8 * 60, 0.01);            // sunrise 5:07, so 7:00 counts
    EXPECT_NEAR(begins(on(2026, 12, 21)), 7 * 60 + 10 + 60, 1.5);  // sunrise 7:10
}

TEST(RuleDays, TrueSolarNoonIsTheTransit) {
    const RuleSun sun = sunOf("japan", sapporo);
    const CivilDate date = on(2026, 12, 21);
    const auto zone = Zone::named("Asia/Tokyo");
    ASSERT_TRUE(zone);
    const SunEvents events = computeSunEvents(
        sapporo.observer, zone->instantAt(date, std::chrono::minutes{0}), SunriseRule::upperLimb);
    const auto off = sun.clock.instantAt(date, 720) - events.transit;
    EXPECT_LT(std::abs(off.count()), 500) << "milliseconds";
    EXPECT_NEAR(sun.clock.minutesOf(date, events.transit), 720, 0.01);
    EXPECT_NEAR(sun.clock.minutesOf(date, sun.clock.instantAt(date, 485.5)), 485.5, 0.01);
    // 8 to 16 h have 480 minutes, half before and half after the transit.
    ASSERT_EQ(sun.sun.days.size(), 1);
    EXPECT_EQ(sun.sun.days[0].count + sun.sun.days[0].belowHorizon, 480);
    const double azimuth = sun.sun.steps.at(240 - sun.sun.days[0].belowHorizon).azimuthDeg;
    EXPECT_NEAR(azimuth, 180, 0.01);
    const RuleSun hokkaido = sunOf("japan", sapporo, {{"limits", "Hokkaido 3 h, 2 h"}});
    EXPECT_EQ(hokkaido.sun.days[0].count, 360);
}

TEST(RuleDays, ZurichCountsMinutes) {
    const RuleSun sun = sunOf("zurich", siteAt(8.54, 47.37, "Europe/Zurich"));
    ASSERT_EQ(sun.sun.days.size(), 2);
    for (const SunDay& day : sun.sun.days) EXPECT_EQ(day.count + day.belowHorizon, 9 * 60);
}

TEST(RuleDays, MaySampleFullHoursOnly) {
    Rule rule = shippedRule("zurich");
    rule.sampling = {60, 60, {}};
    const RuleSun sun = computeRuleSun(rule, siteAt(8.54, 47.37, "Europe/Zurich")).value();
    ASSERT_EQ(sun.sun.days.size(), 2);
    for (const SunDay& day : sun.sun.days) {
        EXPECT_EQ(day.count + day.belowHorizon, 9);
        for (std::size_t i = 0; i < day.count; ++i)
            EXPECT_EQ(sun.clock.timeText(day.date, sun.sun.steps[day.first + i].at),
                      fmt::format("{:02}:00", 8 + i));
    }
}

TEST(RuleDays, TorontoBeginsAt918AndIsTiedToMeanNoon) {
    const RuleSite toronto = siteAt(-79.38, 43.65, "America/Toronto");
    const RuleSun sun = sunOf("toronto", toronto);
    ASSERT_EQ(sun.sun.days.size(), 4);
    EXPECT_EQ(utcOf(sun, 0), "2026-03-21T13:18:00+00:00");
    EXPECT_EQ(sun.sun.days[0].count, 540);
    // On 21 December the last hours lie after sunset.
    EXPECT_GT(sun.sun.days[3].belowHorizon, 60);
}

TEST(RuleDays, VancouverCountsDaylightTime) {
    const RuleSun sun = sunOf("vancouver", siteAt(-123.12, 49.28, "America/Vancouver"));
    EXPECT_EQ(sun.sun.days.size(), 185);  // 21 March to 21 September
    EXPECT_EQ(utcOf(sun, 0), "2026-03-21T17:00:00+00:00");
    EXPECT_EQ(sun.sun.days[0].count, 72);
}

TEST(RuleDays, APolarNightHasNoSteps) {
    const RuleSun sun = sunOf("bre-209-amenity", siteAt(20, 70, "Europe/Oslo"));
    EXPECT_GT(sun.sun.days[0].count, 0);
    Rule rule = shippedRule("bre-209-amenity");
    rule.days.fixed[0].day = std::chrono::December / 21;
    const auto night = computeRuleSun(rule, siteAt(20, 70, "Europe/Oslo"));
    ASSERT_TRUE(night);
    EXPECT_EQ(night->sun.steps.size(), 0);
}

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
