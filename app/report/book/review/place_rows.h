#pragma once

#include "app/report/book/review/review_book.h"

namespace noonmark {

/// A row of a review's sheets: one place, or several that are listed together.
struct PlaceRow {
    std::vector<std::size_t> reviews;  ///< indices into ReviewStudy::places; the first speaks for the others
    QString name;
    int number = 0;  ///< on diagrams, in their key and in tables
};

/// How the sheets of a review list its places.
struct ListedPlaces {
    /// What the proposal changes, fails or is borderline; the worst first. Without a proposal: every place.
    std::vector<PlaceRow> rows;
    std::vector<PlaceRow> others;      ///< places with a name of their own that are in no row
    std::vector<std::size_t> unnamed;  ///< all further reviews
    std::vector<int> numbers;          ///< by place as drawn (ReviewBookSource::places); 0: it has none
};

/// Lists the places as BookSettings says: all of them one by one, or at most `maxPlaceRows` places one by
/// one, with those that are smaller than `leastPlaceM2` and have no name listed together. A place that lies
/// in a larger one goes under its name. `hasProposal`: the scenario differs from the baseline.
ListedPlaces listPlaces(const ReviewBookSource& source, const BookSettings& settings, bool hasProposal);
inline constexpr std::size_t maxPlaceRows = 60;

/// "12 Elm Park": a place of the sheets in a table.
QString numberedName(const PlaceRow& row);
/// "Elm Park"; of a place that its file does not name "plaza without a name".
QString shortName(const Place& place);
/// A place is `perPlace(rule)` reviews, one after the other: a parcel has two belts.
std::size_t placeOf(const ReviewStudy& study, std::size_t review);

}  // namespace noonmark
