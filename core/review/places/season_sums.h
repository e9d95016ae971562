#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/review/places/place_review.h"

namespace noonmark {

/// Incremental shadow on a place in a quarter of the year.
struct SeasonSum {
    std::string_view months;              ///< "December to February"
    double days = 0, daysWithShadow = 0;  ///< of the rule, each weighted by the days that it stands for
    double incrementalM2h = 0;            ///< over these days
    double longestMin = 0;                ///< longest duration on a day
    double maxAreaM2 = 0;                 ///< largest area at one step
    std::string earliest{}, latest{};     ///< first entry and last exit, "08:51"; empty without shadow
};

/// The rows of a review by season, from winter of the northern half of the earth on: December to February,
/// March to May, June to August, September to November. Not for mirrored half years, whose days stand for
/// days of another season.
std::array<SeasonSum, 4> sumSeasons(const PlaceReview& review);

}  // namespace noonmark
