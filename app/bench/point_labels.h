#pragma once

#include <QRectF>
#include <vector>

#include "app/report/maps/style.h"

namespace noonmark {

/// Labels beside points. Labels do not overlap each other or a mark; a label without room is dropped.
class PointLabels {
public:
    /// `within`: the area for labels; `markSize` in painter units.
    PointLabels(const Canvas& canvas, const QRectF& within, double markSize);

    /// Registers the position of a mark. Add all marks before painting labels.
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
