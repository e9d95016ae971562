#include "core/bench/allowance.h"

#include <gtest/gtest.h>

namespace noonmark::bench {
namespace {

int piecesDone(const Allowance& allowance, std::size_t least) {
    Rationed rationed(allowance, least);
    int done = 0;
    while (done < 10 && rationed.next()) ++done;
    return done;
}

TEST(Allowance, anEndlessOneHasRoomForAll) {
    EXPECT_TRUE(Allowance().fits(1e9));
    EXPECT_EQ(piecesDone(Allowance(), 1), 10);
}

TEST(Allowance, aSpentOneHasRoomForWhatIsNeeded) {
    const Allowance spent(-1);
    EXPECT_LT(spent.leftS(), 0);
    EXPECT_FALSE(spent.fits(0));
    EXPECT_EQ(piecesDone(spent, 2), 2);
}

TEST(Allowance, theCheapestPiecesThatFitTogetherAreTaken) {
    EXPECT_EQ(affordable({5, 1, 3, 100}, 8), (std::vector{false, true, true, false}));
    EXPECT_EQ(affordable({5, 1, 3, 100}, 9), (std::vector{true, true, true, false}));
    EXPECT_EQ(affordable({0, 0, 1}, 0), (std::vector{true, true, false})) << "what costs nothing";
}

TEST(Allowance, onlyWhatFitsIsBegun) {
    const Allowance hour(3600);
    EXPECT_TRUE(hour.fits(1800));
    EXPECT_FALSE(hour.fits(3601));
}

}  // namespace
}  // namespace noonmark::bench
