#include "core/measures/shown_error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace noonmark {
namespace {

std::vector<double> oneToHundred() {
    std::vector<double> off;
    for (int i = 100; i >= 1; --i) off.push_back(i);
    return off;
}

TEST(ShownError, StatesMeanTailAndLargest) {
    const ShownError error = sumUpError("place_mean", oneToHundred());
    EXPECT_DOUBLE_EQ(error.mean, 50.5);
    EXPECT_EQ(error.p99, 99);
    EXPECT_EQ(error.largest, 100);
    EXPECT_EQ(error.count, 100U);
    EXPECT_THAT(
        formatText(describe(error)),
        testing::HasSubstr("min a day in the mean, 99 of 100 within 99 min a day, at most 100 min a day"));
}

TEST(ShownError, SmallOnesKeepTwoDigits) {
    const ShownError error = sumUpError("cell_change", {0.00123, 0.0456});
    EXPECT_EQ(formatText(describe(error)),
              "0.023 min a day in the mean, 99 of 100 within 0.046 min a day, at most 0.046 min a day");
}

TEST(ShownError, ThatIsNoneIsReportedOnce) {
    EXPECT_EQ(formatText(describe(sumUpError("place_mean", {0, 0, 0}))), "0 min a day everywhere");
    EXPECT_EQ(formatText(describe(sumUpError("place_mean", {5e-6, 2e-5}))), "0.001 min a day at most")
        << "the rounding of single precision is no error that was measured";
}

// Standard deviation of 1 .. 100: 29.01; over sqrt(100).
TEST(ShownError, OfATotalIsTheMeanTimesItsSize) {
    const ShownError error = sumUpTotalError("score_m2", oneToHundred(), 10);
    EXPECT_DOUBLE_EQ(error.mean, 505);
    EXPECT_NEAR(error.p99, 505 + 10 * 2.58 * 2.90115, 1e-2);
    EXPECT_TRUE(std::isnan(error.largest));
}

TEST(ShownError, ComesBackFromJsonAndUnknownQuantitiesDoNot) {
    const ShownError total = sumUpTotalError("weighted_shade_m2h", oneToHundred(), 10);
    const ShownError date = sumUpError("place_date", {0.25, 0.5}, "2026-12-21");
    nlohmann::ordered_json json = errorsJson(std::vector{total, date});
    json.push_back({{"quantity", "of a later version"}});
    const auto back = parseErrors(json);
    ASSERT_EQ(back.size(), 2U);
    EXPECT_TRUE(std::isnan(back[0].largest));
    EXPECT_EQ(back[1].of, "2026-12-21");
    EXPECT_EQ(back[1].largest, 0.5);
    EXPECT_EQ(labelOf(back[1]), "Mean sun of a place on a date, 2026-12-21");
    EXPECT_TRUE(parseErrors(nullptr).empty());
}

}  // namespace
}  // namespace noonmark
