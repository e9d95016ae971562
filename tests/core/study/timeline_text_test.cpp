#include "core/study/place_study.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

TEST(TimelineCsv, NamesAreTextsInASpreadsheet) {
    DayTimeline day;
    day.day = std::chrono::year(2026) / 3 / 21;
    day.steps.push_back({.baselineM2 = 1, .scenarioM2 = 2.5, .incrementalM2 = 1.5});
    const auto timeline = [&](const char* name) {
        PlaceTimeline of;
        of.place = {name, PlaceKind::park, {}, ""};
        of.days = {day};
        return of;
    };
    const PlaceStudy study{.places = {timeline("=1+1"), timeline("Park, north")}};
    const std::string csv = timelineCsv(study, {.from = "Existing", .zone = Zone::named("UTC").value()});
    EXPECT_NE(csv.find("\n'=1+1,2026-03-21,"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\n\"Park, north\",2026-03-21,"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",1.00,2.50,1.50,0.00\r\n"), std::string::npos) << csv;
}

TEST(TimelineJson, StatesTimesAndCoversInEachColumnOfTrees) {
    const Instant nine{std::chrono::hours(9)}, ten{std::chrono::hours(10)}, noon{std::chrono::hours(12)};
    PlaceTimeline place;
    place.place = {"Park", PlaceKind::park, {}, ""};
    place.days.push_back({.baseline = {.intervals = {{nine, ten}}, .minutes = 60}, .fullCoverMin = 0});
    place.longestIncrementalAt = {std::nullopt};
    ShadedPlace& with = place.withTrees.emplace_back();
    with.column = TreeColumns::evergreen;
    with.days.push_back({.baseline = {.intervals = {{nine, noon}}, .minutes = 180}, .fullCoverMin = 25});
    with.longestIncrementalAt = {LonLat{1, 2}};
    const PlaceStudy study{.places = {place}, .treesUsed = 3};
    const auto json = timelineJson(study, place, {.from = "Existing", .zone = Zone::named("UTC").value()});
    EXPECT_EQ(json["baseline"]["exits"], "1970-01-01T10:00:00+00:00");
    EXPECT_EQ(json["baseline"]["exits_evergreen"], "1970-01-01T12:00:00+00:00");
    EXPECT_EQ(json["baseline"]["duration_min_evergreen"], 180);
    EXPECT_EQ(json["baseline"]["intervals_evergreen"].size(), 1U);
    EXPECT_EQ(json["full_cover_min"], 0);
    EXPECT_EQ(json["full_cover_min_evergreen"], 25);
    EXPECT_EQ(json["incremental"]["longest_stay_at_evergreen"]["lon"], 1);
    EXPECT_FALSE(json["incremental"].contains("longest_stay_at"));
    EXPECT_FALSE(json["baseline"].contains("exits_seasonal"));
}

}  // namespace
}  // namespace noonmark
