#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/units.h"
#include "core/describe/figure.h"
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

/// The numbers of a row. In JSON, CSV and, with "-" for nothing, in the tables of rules.
const Figures<ReviewRow>& reviewRowFigures();

/// Whether a rule's table may have a column of that key: one of reviewColumnKeys(), or "criterion.KEY" for
/// the day's value of one of the rule's criteria.
bool isReviewColumn(const Rule& rule, std::string_view key);

/// "day", "enters", ...: docs/rules.md lists them with their units.
std::vector<std::string_view> reviewColumnKeys();

/// Columns as they are shown to people: a column of square metres ("max_area_m2", "baseline_m2h") becomes one
/// of square feet for imperial, and is followed by one for both, unless the rule has that column, too. Its
/// title states the unit. All other columns stay as they are.
std::vector<RuleColumn> columnsIn(UnitSystem units, const std::vector<RuleColumn>& columns);

/// The text of one field of a row in that column, for people: "-" where there is no value. Numbers have a
/// decimal point and commas between thousands; tables that programs read take the row itself.
std::string columnText(const PlaceReview& review, const ReviewRow& row, std::string_view key);

}  // namespace noonmark
