#pragma once

#include "app/report/maps/style.h"
#include "core/study/study.h"

namespace noonmark {

/// The heading of a picture or page: title; dates and hours; place and sunlit time.
struct Headline {
    QString what;
    QString when;
    QString where;
};

/// `subject`: "Shadow study", "Gross shadow"; followed by the name of the region if it has one.
Headline makeHeadline(const Study& study, const QString& subject);
/// The same for any result with `settings` over a city in `frame`. `sunlit`: text on the sunlit time per day;
/// empty where unknown.
Headline makeHeadline(const StudySettings& settings, const Frame& frame, const QString& subject,
                      const QString& sunlit);

constexpr double headlineHeightPt = 50;

/// Paints from the top of `area`, headlineHeightPt high. A line that is too long is set smaller, then cut
/// with an ellipsis.
void paintHeadline(const Canvas& canvas, const QRectF& area, const Headline& headline);

/// Paints one line across `area`: the data credit at the left, the program at the right.
void paintSmallPrint(const Canvas& canvas, const QRectF& area, const QString& credit);

}  // namespace noonmark
