#include "core/bench/contests/contest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace noonmark::bench {
namespace {

TEST(BenchContestants, EveryEngineOfTheListRunsWithItsDefaults) {
    const StartList list = listDefaultEngines(coreEngines());
    EXPECT_EQ(list.contestants.size() + list.absent.size(), coreEngines().size());
    for (const Contestant& contestant : list.contestants) EXPECT_TRUE(contestant.setting.empty());
}

TEST(BenchContestants, SettingsAreTriedOnceEach) {
    const StartList list = listVariedEngines(coreEngines(), {0.25, 0.5, 1, 2, 4});
    std::set<std::string> titles;
    for (const Contestant& contestant : list.contestants)
        EXPECT_TRUE(titles.insert(makeTitle(contestant)).second) << makeTitle(contestant);
    EXPECT_TRUE(titles.contains("Horizon sweep"));
    EXPECT_TRUE(titles.contains("Horizon sweep, error 0.1 %"));
    EXPECT_TRUE(titles.contains("Inverse accrual map, levels 6"));
    EXPECT_TRUE(titles.contains("Inverse accrual map, levels 8"));  // 12 clamped
}

TEST(BenchContestants, ALadderHasTheDefaultRungToo) {
    const auto ladder = listVariants(coreEngines(), "iam", "levels", {1, 2, 3});
    ASSERT_EQ(ladder.size(), 3U);
    EXPECT_EQ(ladder[0].setting, "levels 1");
    EXPECT_EQ(ladder[2].setting, "");
    EXPECT_TRUE(listVariants(coreEngines(), "none", "levels", {1}).empty());
}

}  // namespace
}  // namespace noonmark::bench
