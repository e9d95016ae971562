#include "core/review/places/season_sums.h"

#include <algorithm>

namespace noonmark {

namespace {

void addRow(const ReviewRow& row, SeasonSum& sum) {
    sum.days += row.weight;
    if (row.durationMin <= 0) return;
    sum.daysWithShadow += row.weight;
    sum.incrementalM2h += row.weight * row.incrementalM2h;
    sum.longestMin = std::max(sum.longestMin, row.durationMin);
    sum.maxAreaM2 = std::max(sum.maxAreaM2, row.maxAreaM2);
    // Times of a clock have two digits for the hour, so texts are in the order of times.
    if (row.entersText.empty()) return;  // shadow between the centres of cells alone has no times
    if (sum.earliest.empty() || row.entersText < sum.earliest) sum.earliest = row.entersText;
    sum.latest = std::max(sum.latest, row.exitsText);
}

}  // namespace

std::array<SeasonSum, 4> sumSeasons(const PlaceReview& review) {
    std::array<SeasonSum, 4> seasons{SeasonSum{"December to February"}, SeasonSum{"March to May"},
                                     SeasonSum{"June to August"}, SeasonSum{"September to November"}};
    for (const ReviewRow& row : review.rows) addRow(row, seasons[unsigned(row.day.month()) % 12 / 3]);
    return seasons;
}

}  // namespace noonmark
