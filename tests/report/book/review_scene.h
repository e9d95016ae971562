#pragma once

#include "app/report/book/review/review_book.h"

namespace noonmark::tests {

/// A park of 100 m x 60 m north of a tower of 60 m that only the scenario has, in New York; reviewed by a
/// rule with diagrams at 10:00 and 14:00 on 21 March and 21 June. Names may be chosen.
class ReviewedPark {
public:
    explicit ReviewedPark(const std::string& placeName = "Park", const std::string& scenarioName = "Tower");

    [[nodiscard]] ReviewBookSource source() const { return {study, labels, before, after, places}; }
    [[nodiscard]] Book book(const BookSettings& settings) const;

    City before, after;
    std::vector<Place> places;
    ReviewLabels labels;
    ReviewStudy study;
};

Footprint boxFootprint(float west, float south, float east, float north);

}  // namespace noonmark::tests
