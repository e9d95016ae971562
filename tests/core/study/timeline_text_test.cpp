#include "core/study/place_study.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

TEST(TimelineCsv, NamesAreTextsInASpreadsheet) {
    DayTimeline day;
    day.day = std::chrono::year(2026) / 3 / 21;
    day.steps.push_back({.baselineM2 = 1, .scenarioM2 = 2.5, .incrementalM2 = 1.5});
    const auto timeline = [&](const char* name) {
        return PlaceTimeline{.place = {name, PlaceKind::park, {}, ""}, .days = {day}};
    };
    const PlaceStudy study{.places = {timeline("=1+1"), timeline("Park, north")}};
    const std::string csv = timelineCsv(study, {.from = "Existing", .zone = Zone::named("UTC").value()});
    EXPECT_NE(csv.find("\n'=1+1,2026-03-21,"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\n\"Park, north\",2026-03-21,"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",1.00,2.50,1.50,0.00\r\n"), std::string::npos) << csv;
}

}  // namespace
}  // namespace noonmark
