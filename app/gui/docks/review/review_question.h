#pragma once

#include <memory>

#include "app/gui/docks/review/review_choice.h"
#include "core/measures/place_screening.h"
#include "core/review/library/rule_library.h"
#include "core/study/review_study.h"

namespace noonmark {

/// A review, complete: it can be computed on another thread.
struct ReviewQuestion {
    Rule rule;
    std::string from, to;  ///< names of baseline and scenario
    std::shared_ptr<const City> before, after;
    std::vector<Place> places;  ///< or parcels, of a rule with lines
    ReviewSettings settings;
    Warnings moved;  ///< parcels with roads: their line was moved out, or why not
};

/// Whether both have the same answer.
bool isSame(const ReviewQuestion& a, const ReviewQuestion& b);

/// A question with its answer.
struct ReviewAnswer {
    ReviewQuestion question;
    ReviewStudy study;
    double seconds = 0;  ///< to compute it
    /// The place of study.places[review]; a parcel has two reviews.
    [[nodiscard]] const Place& placeOf(std::size_t review) const;
};

/// Rules of a few days are computed again by themselves; those of a range of days on request.
bool hasFewDays(const Rule& rule);

Result<ReviewAnswer> computeReview(const ReviewQuestion& question, Progress& progress, std::stop_token stop);

/// Which places can be reached, by the days and hours of the rule (of a range one day in seven, every ten
/// minutes).
Result<std::vector<ScreenedPlace>> screen(const ReviewQuestion& question, Progress& progress,
                                          std::stop_token stop);

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
