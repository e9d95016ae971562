#include "app/report/book/review/review_pages.h"

#include <algorithm>
#include <numeric>

#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/study_text.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

bool isBad(const PlaceReview& review) {
    return review.verdict == Verdict::fail || review.verdict == Verdict::borderline;
}

int rankOf(const PlaceReview& review) {
    return review.verdict == Verdict::fail ? 0 : review.verdict == Verdict::borderline ? 1 : 2;
}

/// Places that fail, then borderline ones, then the others; among equals those with most incremental shadow.
std::vector<std::size_t> worstFirst(const ReviewStudy& study) {
    std::vector<std::size_t> order(study.places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        const PlaceReview& review = study.places[i];
        return std::pair(rankOf(review), -review.totals.incrementalM2h);
    });
    return order;
}

/// Sorts the places into rows.
class PlaceSorter {
public:
    PlaceSorter(const ReviewBookSource& source, const BookSettings& settings, bool hasProposal)
        : source_(source), settings_(settings), hasProposal_(hasProposal) {
        for (const Place& place : source.places) {
            areas_.push_back(area(place));
            bounds_.push_back(bounds(place));
        }
    }

    ListedPlaces sort() {
        for (const std::size_t i : worstFirst(source_.study)) take(i);
        for (PlaceRow& row : together_) {
            if (row.reviews.size() == 1) row.name = nameOne(row.reviews.front());
            list_.rows.push_back(std::move(row));
        }
        std::ranges::stable_sort(list_.rows, {},
                                 [&](const PlaceRow& row) { return rankOf(reviewOf(row.reviews.front())); });
        number();
        return std::move(list_);
    }

private:
    [[nodiscard]] const PlaceReview& reviewOf(std::size_t i) const { return source_.study.places[i]; }
    [[nodiscard]] std::size_t drawn(std::size_t review) const { return placeOf(source_.study, review); }

    void take(std::size_t i) {
        const PlaceReview& review = reviewOf(i);
        const Place& place = source_.places[drawn(i)];
        const bool isListed =
            !hasProposal_ || isBad(review) || review.totals.incrementalM2h > 0 || review.totals.gainedM2h > 0;
        if (settings_.allPages || (isListed && !isPiece(drawn(i)) && list_.rows.size() < maxPlaceRows))
            list_.rows.push_back({{i}, plainText(review.name)});
        else if (isListed)
            addTogether(i);
        else if (hasOwnName(place))
            list_.others.push_back({{i}, plainText(review.name)});
        else
            list_.unnamed.push_back(i);
    }

    [[nodiscard]] bool isPiece(std::size_t place) const {
        return areas_[place] < settings_.minPlaceM2 && !hasOwnName(source_.places[place]);
    }

    /// Rows of places together have one verdict.
    void addTogether(std::size_t i) {
        const QString name = nameGroup(i);
        const auto row = std::ranges::find_if(together_, [&](const PlaceRow& one) {
            return one.name == name && reviewOf(one.reviews.front()).verdict == reviewOf(i).verdict;
        });
        if (row != together_.end()) return row->reviews.push_back(i);
        together_.push_back({{i}, name});
    }

    // One without a name, "playground (OSM way 12)", has its kind in the language of the sheet.
    [[nodiscard]] QString nameOne(std::size_t i) const {
        const std::string& name = reviewOf(i).name;
        const std::string_view kind = nameOf(reviewOf(i).kind);
        if (!name.starts_with(std::string(kind) + " (")) return plainText(name);
        return sheetText(kind) + u' ' + plainText(name.substr(kind.size()));
    }

    [[nodiscard]] QString nameGroup(std::size_t i) const {
        const QString kind = sheetText(nameOf(reviewOf(i).kind));
        if (!isPiece(drawn(i))) return sheetText("further places: %1").arg(kind);
        const QString size = QString::fromStdString(formatArea(settings_.minPlaceM2, settings_.units));
        if (const Place* around = findAround(drawn(i)))
            return sheetText("%1: pieces of less than %2").arg(plainText(around->name), size);
        return sheetText("%1, pieces of less than %2").arg(kind, size);
    }

    /// The smallest place with a name that holds the first corner of a piece; null without one.
    [[nodiscard]] const Place* findAround(std::size_t piece) const {
        const glm::vec2 corner = source_.places[piece].polygons.front().outer.front();
        const Place* found = nullptr;
        double minimum = 0;
        for (std::size_t i = 0; i < source_.places.size(); ++i) {
            const Place& place = source_.places[i];
            const Box2& box = bounds_[i];
            const bool isNear = corner.x >= box.low.x && corner.y >= box.low.y && corner.x <= box.high.x &&
                                corner.y <= box.high.y;
            if (i == piece || !isNear || !hasOwnName(place) || (found && areas_[i] >= minimum)) continue;
            if (std::ranges::none_of(place.polygons, [&](const Footprint& polygon) {
                    return contains(polygon, glm::dvec2(corner));
                }))
                continue;
            found = &place;
            minimum = areas_[i];
        }
        return found;
    }

    void number() {
        list_.numbers.assign(source_.places.size(), 0);
        int next = 0;
        for (auto* rows : {&list_.rows, &list_.others})
            for (PlaceRow& row : *rows) {
                int& first = list_.numbers[drawn(row.reviews.front())];
                if (first == 0) first = ++next;
                row.number = first;
                for (const std::size_t i : row.reviews) list_.numbers[drawn(i)] = row.number;
            }
    }

    const ReviewBookSource& source_;
    const BookSettings& settings_;
    bool hasProposal_;
    std::vector<double> areas_;
    std::vector<Box2> bounds_;
    ListedPlaces list_;
    std::vector<PlaceRow> together_;
};

}  // namespace

ListedPlaces listPlaces(const ReviewBookSource& source, const BookSettings& settings, bool hasProposal) {
    return PlaceSorter(source, settings, hasProposal).sort();
}

QString numberedName(const PlaceRow& row) {
    const QString count =
        row.reviews.size() > 1 ? describeCount(row.reviews.size()) + QStringLiteral(" × ") : QString();
    return QString::number(row.number) + QStringLiteral("  ") + count + row.name;
}

QString shortName(const Place& place) {
    if (hasOwnName(place)) return plainText(place.name);
    return sheetText(nameOf(place.kind)) + sheetText(" without a name");
}

std::size_t placeOf(const ReviewStudy& study, std::size_t review) {
    return study.rule.receivers.hasLines() ? review / 2 : review;
}

}  // namespace noonmark
