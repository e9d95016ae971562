#include "core/measures/places/place_sums.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <vector>

#include "tests/core/simd/random_blocks.h"

namespace noonmark::tests {
namespace {

TEST(StepCounts, AreThoseOfCountingBitByBitOnEverySet) {
    std::mt19937_64 random(16);
    for (const std::size_t words : {0U, 1U, 3U, 4U, 7U, 8U, 9U, 31U, 500U}) {
        std::vector<std::uint64_t> before(words), after(words);
        StepCounts expected;
        for (std::size_t i = 0; i < words; ++i) {
            const std::uint64_t one = random(), other = random();
            before[i] = i % 5 == 0 ? ~std::uint64_t{0} : one & other;
            after[i] = i % 7 == 0 ? 0 : random();
            expected.baseline += std::size_t(std::popcount(before[i]));
            expected.scenario += std::size_t(std::popcount(after[i]));
            expected.incremental += std::size_t(std::popcount(after[i] & ~before[i]));
        }
        forEachInstructionSet([&] { EXPECT_EQ(countStep(before, after), expected) << words; });
    }
}

}  // namespace
}  // namespace noonmark::tests
