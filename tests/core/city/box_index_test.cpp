#include "core/city/footprints/plan_overlay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(BoxIndex, FindsBoxesThatMeetOrTouchByTheirPosition) {
    // A row of 100 boxes of 1 m with gaps of 1 m.
    std::vector<Box2> boxes;
    for (int i = 0; i < 100; ++i) boxes.push_back({{2.0F * float(i), 0}, {2.0F * float(i) + 1, 1}});
    const BoxIndex index(boxes);
    EXPECT_THAT(index.findMeeting({{10.5F, 0.5F}, {13, 0.6F}}), ElementsAre(5, 6));
    EXPECT_THAT(index.findMeeting({{11, 1}, {12, 2}}), ElementsAre(5, 6)) << "both are touched at a corner";
    EXPECT_THAT(index.findMeeting({{11.2F, 0}, {11.8F, 1}}), IsEmpty()) << "a gap";
}

TEST(BoxIndex, EmptyBoxesMeetNothingAndMayBeMoved) {
    const Box2 full{{0, 0}, {1, 1}};
    BoxIndex index({Box2(), full});
    EXPECT_THAT(index.findMeeting(Box2()), IsEmpty());
    const BoxIndex other = std::move(index);
    EXPECT_THAT(other.findMeeting(full), ElementsAre(1));
    EXPECT_THAT(BoxIndex({}).findMeeting(full), IsEmpty());
}

}  // namespace
}  // namespace noonmark
