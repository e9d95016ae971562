#pragma once

#include "app/report/sheets/style.h"
#include "core/study/study.h"

namespace noonmark {

/// What a picture or a page is about: the title; when; where, and for how long the sun is up.
struct Headline {
    QString what;
    QString when;
    QString where;
};

/// `subject`: "Shadow study", "Gross shadow"; the name of the region is added where it has one.
Headline makeHeadline(const Study& study, const QString& subject);
/// The same of any answer to `settings` over a city in `frame`; `sunlit`: of its days, empty where not known.
Headline makeHeadline(const StudySettings& settings, const Frame& frame, const QString& subject,
                      const QString& sunlit);

constexpr double headlineHeightPt = 50;

/// From the top of `area`, headlineHeightPt high; a line that is too long gets smaller letters, then an
/// ellipsis.
void paintHeadline(const Canvas& canvas, const QRectF& area, const Headline& headline);

/// One line of small print across `area`: whose data it is at the left, what made it at the right.
void paintSmallPrint(const Canvas& canvas, const QRectF& area, const QString& credit);

}  // namespace noonmark
