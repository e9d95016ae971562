#pragma once

#include "app/questions/review_question.h"

namespace noonmark {

/// Rules of a few days are computed again by themselves; those of a range of days on request.
bool hasFewDays(const Rule& rule);

/// A rule of a range of days as places are screened by it: one day in seven, every ten minutes.
Rule thinnedOut(Rule rule);

/// The timeline behind one review on one day of any year that the rule's clock covers, with the rule's hours
/// and step.
struct ReviewDay {
    DayTimeline day;
    DayClock clock;
    double stepMinutes = 1;
};
Result<ReviewDay> computeReviewDay(const ReviewAnswer& answer, std::size_t review, CivilDate day,
                                   Progress& progress, std::stop_token stop);

/// The timelines behind one review on the days of the rule's range (at most every second day of a long one),
/// in steps of ten minutes or the rule's if they are longer.
struct ReviewRange {
    std::vector<DayTimeline> days;
    DayClock clock;
    double stepMinutes = 10;
};
Result<ReviewRange> computeReviewRange(const ReviewAnswer& answer, std::size_t review, Progress& progress,
                                       std::stop_token stop);

}  // namespace noonmark
