#pragma once

#include <QRectF>
#include <vector>

#include "app/report/sheets/style.h"

namespace noonmark {

/// Words beside points, none upon another word or a mark; a word without room is left away.
class PointLabels {
public:
    /// `within`: where words may stand; `markSize` in painter units.
    PointLabels(const Canvas& canvas, const QRectF& within, double markSize);

    /// Where a mark is; all marks first, then the words.
    void addMark(const QPointF& at);
    void paint(const QPointF& at, const QString& text, const QColor& colour);

private:
    [[nodiscard]] bool isFree(const QRectF& box) const;

    Canvas canvas_;
    QRectF within_;
    double markSize_;
    std::vector<QRectF> taken_;
};

}  // namespace noonmark
