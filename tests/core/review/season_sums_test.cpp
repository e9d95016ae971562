#include "core/review/places/review_columns.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

ReviewRow rowOn(unsigned month, unsigned day, double durationMin, double m2h, const char* enters = "",
                const char* exits = "") {
    ReviewRow row;
    row.day = {std::chrono::year{2026}, std::chrono::month{month}, std::chrono::day{day}};
    row.durationMin = durationMin;
    row.incrementalM2h = m2h;
    row.maxAreaM2 = 10 * m2h;
    row.entersText = enters;
    row.exitsText = exits;
    return row;
}

TEST(SeasonSums, DecemberBelongsToJanuaryAndFebruary) {
    PlaceReview review;
    review.rows = {rowOn(1, 5, 60, 3, "10:00", "11:00"), rowOn(2, 28, 0, 0), rowOn(3, 1, 0, 0),
                   rowOn(12, 21, 90, 5, "09:30", "11:00"), rowOn(8, 31, 15, 1, "18:00", "18:15")};
    const auto seasons = sumSeasons(review);
    EXPECT_EQ(seasons[0].days, 3);
    EXPECT_EQ(seasons[0].daysWithShadow, 2);
    EXPECT_EQ(seasons[0].incrementalM2h, 8);
    EXPECT_EQ(seasons[0].longestMin, 90);
    EXPECT_EQ(seasons[0].maxAreaM2, 50);
    EXPECT_EQ(seasons[0].earliest, "09:30");
    EXPECT_EQ(seasons[0].latest, "11:00");
    EXPECT_EQ(seasons[1].days, 1);
    EXPECT_EQ(seasons[1].earliest, "");
    EXPECT_EQ(seasons[2].incrementalM2h, 1);
    EXPECT_EQ(seasons[3].days, 0);
}

TEST(SeasonSums, DaysCountAsOftenAsTheyStandForOthers) {
    PlaceReview review;
    review.rows = {rowOn(4, 7, 30, 2, "08:00", "08:30")};
    review.rows[0].weight = 7;  // one day of seven
    const SeasonSum spring = sumSeasons(review)[1];
    EXPECT_EQ(spring.days, 7);
    EXPECT_EQ(spring.incrementalM2h, 14);
    EXPECT_EQ(spring.longestMin, 30);
}

}  // namespace
}  // namespace noonmark
