#include "core/lab/bench/finding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/lab/bench/contests/moments.h"

namespace noonmark::bench {
namespace {

TEST(BenchTable, CsvQuotesWhatNeedsItAndLeavesWhatIsMissingEmpty) {
    const Table table{{"engine", "time_s", "refusal"},
                      {{std::string("iam"), 0.1, std::monostate{}},
                       {std::string("a \"b\", c"), std::monostate{}, std::string("two\nlines")}}};
    EXPECT_EQ(toCsv(table),
              "engine,time_s,refusal\r\n"
              "iam,0.1,\r\n"
              "\"a \"\"b\"\", c\",,\"two\nlines\"\r\n");
}

TEST(BenchTable, NumbersComeBackExactly) {
    const double third = 1.0 / 3;
    const std::string csv = toCsv({{"x"}, {{third}}});
    EXPECT_EQ(std::stod(csv.substr(2)), third);
}

TEST(BenchMoments, OfKnownValues) {
    const Moments moments = computeMoments({4, 1, 3, 2});
    EXPECT_DOUBLE_EQ(moments.mean, 2.5);
    EXPECT_DOUBLE_EQ(moments.median, 2.5);
    EXPECT_DOUBLE_EQ(moments.deviation, std::sqrt(1.25));
    EXPECT_EQ(moments.minimum, 1);
    EXPECT_EQ(moments.maximum, 4);
    EXPECT_EQ(computeMoments({5, 9, 1}).median, 5);
    EXPECT_EQ(computeMoments({}).mean, 0);
}

TEST(BenchMoments, ThreeDigitsHaveNoExponent) {
    EXPECT_EQ(formatThreeDigits(0.012345), "0.0123");
    EXPECT_EQ(formatThreeDigits(12.345), "12.3");
    EXPECT_EQ(formatThreeDigits(3097.89), "3098");
}

}  // namespace
}  // namespace noonmark::bench
