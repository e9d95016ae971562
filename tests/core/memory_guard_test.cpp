#include "core/base/memory_guard.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

TEST(MemoryGuard, WorkThatSucceedsOrFailsByItselfIsPassedOn) {
    bool dropped = false;
    const auto drop = [&] { dropped = true; };
    EXPECT_EQ(guardMemory(
                  {}, [] { return Result<int>(7); }, drop)
                  .value(),
              7);
    const Result<int> failed = guardMemory(
        {}, []() -> Result<int> { return failure("no file"); }, drop);
    EXPECT_EQ(failed.error().what, "no file");
    EXPECT_EQ(failed.error().kind, ErrorKind::input);
    EXPECT_FALSE(dropped);
}

TEST(MemoryGuard, ALackOfMemoryDropsWhatIsHalfDoneAndIsALimit) {
    bool dropped = false;
    const auto lacking = []() -> Result<void> { throw std::bad_alloc(); };
    const Result<void> failed = guardMemory({"this view", "ray reference", "Choose a smaller view"}, lacking,
                                            [&] { dropped = true; });
    ASSERT_FALSE(failed);
    EXPECT_TRUE(dropped);
    EXPECT_EQ(failed.error().kind, ErrorKind::limit);
    EXPECT_EQ(failed.error().text(),
              "ray reference: There is not enough memory for this view. Choose a smaller view");
}

}  // namespace
}  // namespace noonmark
