#include "core/lab/bench/work.h"

#include <gtest/gtest.h>

namespace noonmark::bench {
namespace {

TEST(Allowance, AnEndlessOneHasRoomForAll) { EXPECT_GT(Allowance().secondsLeft(), 1e9); }

TEST(Allowance, TheLongerItLastsTheLessIsLeft) {
    const Allowance hour(3600);
    const double before = hour.secondsLeft();
    EXPECT_LE(before, 3600);
    EXPECT_LE(hour.secondsLeft(), before);
}

TEST(Allowance, TheCheapestPiecesThatFitTogetherAreTaken) {
    EXPECT_EQ(canAfford({5, 1, 3, 100}, 8), (std::vector{false, true, true, false}));
    EXPECT_EQ(canAfford({5, 1, 3, 100}, 9), (std::vector{true, true, true, false}));
    EXPECT_EQ(canAfford({0, 0, 1}, 0), (std::vector{true, true, false})) << "what costs nothing";
}

}  // namespace
}  // namespace noonmark::bench
