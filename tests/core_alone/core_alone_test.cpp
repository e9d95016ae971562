// A program that embeds core and scenarios without the lab (core/lab). It links all of both, so that a call
// from one of them into the lab fails the build.
#include <gmock/gmock.h>

#include "core/base/progress.h"
#include "core/study/study.h"

namespace noonmark {
namespace {

City towerAtOrigin() {
    City city{.frame = Frame({-73.98, 40.75})};
    Building tower{.sourceId = "tower"};
    tower.parts.push_back({.footprint = {{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, {}}, .topM = 30});
    city.buildings = {std::make_shared<const Building>(tower)};
    return city;
}

// Days at an equinox: between nine and three the sun stands in the south, so shadows fall north of the tower.
TEST(CoreAlone, AnswersAStudyWithoutTheLab) {
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({{-50, -50}, {50, 50}});
    settings.receivers.cellM = 2;
    settings.period.start = std::chrono::year{2026} / 3 / 20;
    settings.period.zone = "America/New_York";
    NoProgress progress;
    for (const EngineEntry& engine : coreEngines()) {
        settings.engine = engine.info.key;
        const auto study = runStudy(towerAtOrigin(), settings, progress, {});
        ASSERT_TRUE(study) << study.error().text();
        // Centres at -5, -3, -1, 1 and 3 m lie in the tower, whose edges are half-open.
        ASSERT_EQ(study->receivers.cells.size(), 50U * 50U - 5U * 5U);
        const auto minutesAt = [&](std::uint32_t column, std::uint32_t row) {
            return study->field.grossMin[study->receivers.grid.index(column, row)];
        };
        EXPECT_GT(minutesAt(25, 30), 60) << "north of the tower";
        for (std::uint32_t column = 0; column < 50; ++column)
            EXPECT_EQ(minutesAt(column, 10), 0) << "south of the tower";
    }
}

TEST(CoreAlone, AnEngineOfTheLabIsUnknownToIt) {
    const auto refused = makeEngine("iam");
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), testing::HasSubstr("horizon"));
}

}  // namespace
}  // namespace noonmark
