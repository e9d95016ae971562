#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

#include "core/city/footprints/plan_overlay.h"

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

using testing::Pair;

Footprint box(float west, float south, float width, float height) {
    return {{{west, south}, {west + width, south}, {west + width, south + height}, {west, south + height}},
            {}};
}

TEST(PiecesOutside, AreWhatIsNotCovered) {
    const auto pieces = cutPiecesOutside({box(0, 0, 30, 10)}, {box(10, -5, 10, 20)}, {});
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_NEAR(area(pieces), 200, 1e-3);
    for (const Footprint& piece : pieces) EXPECT_GT(signedArea(piece.outer), 0);
}

TEST(PiecesOutside, MayHaveACourtyard) {
    const auto pieces = cutPiecesOutside({box(0, 0, 30, 30)}, {box(10, 10, 10, 10)}, {});
    ASSERT_EQ(pieces.size(), 1U);
    ASSERT_EQ(pieces[0].holes.size(), 1U);
    EXPECT_LT(signedArea(pieces[0].holes[0]), 0);
}

TEST(PiecesOutside, LeaveOutWhatIsTooSmallOrTooNarrow) {
    EXPECT_THAT(cutPiecesOutside({box(0, 0, 100, 10)}, {box(0, 0, 100, 9.5F)}, {}), IsEmpty());
    EXPECT_THAT(cutPiecesOutside({box(0, 0, 3, 13)}, {box(0, 0, 3, 10)}, {}), IsEmpty());
    EXPECT_EQ(cutPiecesOutside({box(0, 0, 3, 13)}, {box(0, 0, 3, 10)}, {.areaM2 = 5, .widthM = 1}).size(),
              1U);
}

TEST(PiecesOutside, IsAllWhereNothingCoversIt) {
    EXPECT_NEAR(area(cutPiecesOutside({box(0, 0, 5, 5)}, {}, {})), 25, 1e-3);
    EXPECT_THAT(cutPiecesOutside({box(0, 0, 5, 5)}, {box(-1, -1, 9, 9)}, {}), IsEmpty());
}

TEST(SharedArea, CountsWhatBothCover) {
    EXPECT_NEAR(computeSharedArea({box(0, 0, 10, 10)}, {box(5, 5, 10, 10)}), 25, 1e-6);
    EXPECT_DOUBLE_EQ(computeSharedArea({box(0, 0, 10, 10)}, {box(10, 0, 10, 10)}), 0);
    EXPECT_DOUBLE_EQ(computeSharedArea({}, {box(10, 0, 10, 10)}), 0);
}

TEST(MeetingBoxes, AreFoundAsByLookingAtAllPairs) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> place(0, 100);
    std::uniform_real_distribution<float> size(0, 12);
    const auto boxes = [&](int count) {
        std::vector<Box2> made;
        for (int i = 0; i < count; ++i) {
            const glm::vec2 low(place(random), place(random));
            made.push_back({low, low + glm::vec2(size(random), size(random))});
        }
        return made;
    };
    const auto a = boxes(80);
    const auto b = boxes(120);
    std::vector<std::pair<std::size_t, std::size_t>> expected;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            if (a[i].low.x <= b[j].high.x && b[j].low.x <= a[i].high.x && a[i].low.y <= b[j].high.y &&
                b[j].low.y <= a[i].high.y)
                expected.emplace_back(i, j);
    EXPECT_EQ(findMeetingBoxes(a, b), expected);
}

TEST(MeetingBoxes, PassOverEmptyOnes) {
    const Box2 full{{0, 0}, {1, 1}};
    EXPECT_THAT(findMeetingBoxes({Box2(), full}, {full, Box2()}), ElementsAre(Pair(1, 0)));
    EXPECT_THAT(findMeetingBoxes({}, {full}), IsEmpty());
    EXPECT_THAT(findMeetingBoxes({full}, {}), IsEmpty());
}

}  // namespace

}  // namespace noonmark
