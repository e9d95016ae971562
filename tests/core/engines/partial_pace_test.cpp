#include "core/engines/api/partial_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace noonmark {
namespace {

// Times at which results are taken by work that checks every `stepS`, starting late.
std::vector<double> takenBy(double stepS, double untilS) {
    PartialPace pace;
    std::vector<double> taken;
    for (int look = 1; 1 + look * stepS < untilS; ++look) {
        const double now = 1 + look * stepS;
        if (!pace.due(now)) continue;
        pace.taken(now);
        taken.push_back(now);
    }
    return taken;
}

TEST(PartialPace, FiveASecondHoweverOftenTheWorkLooksUp) {
    for (const double stepS : {0.001, 0.03, 0.07, 0.11, 0.17}) {
        const auto taken = takenBy(stepS, 21);
        EXPECT_GE(double(taken.size()) / (taken.back() - 1), 5) << stepS;
        EXPECT_LE(double(taken.size()), 20 / PartialPace::defaultS + 2) << "and no more than that, " << stepS;
    }
}

TEST(PartialPace, WorkThatSeldomLooksUpShowsAllItHas) {
    EXPECT_GE(double(takenBy(0.25, 21).size()), 0.9 * 20 / 0.25);
}

TEST(PartialPace, ALongPauseIsNotMadeGood) {
    PartialPace pace;
    pace.taken(0);
    ASSERT_TRUE(pace.due(10));
    pace.taken(10);
    EXPECT_FALSE(pace.due(10.1));
    EXPECT_TRUE(pace.due(10 + PartialPace::defaultS));
}

TEST(PartialPace, OnesThatComeUnaskedDoNotAddUp) {
    PartialPace pace;
    for (int i = 0; i < 10; ++i) pace.taken(1 + 0.01 * i);
    EXPECT_FALSE(pace.due(1.1));
    EXPECT_TRUE(pace.due(1.1 + PartialPace::defaultS));
}

}  // namespace
}  // namespace noonmark
