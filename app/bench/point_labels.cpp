#include "app/bench/point_labels.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>

namespace noonmark {

namespace {
constexpr double labelPt = 5.8;
}

PointLabels::PointLabels(const Canvas& canvas, const QRectF& within, double markSize)
    : canvas_(canvas), within_(within), markSize_(markSize) {}

void PointLabels::addMark(const QPointF& at) {
    const double half = 0.6 * markSize_;
    taken_.emplace_back(at - QPointF(half, half), QSizeF(2 * half, 2 * half));
}

void PointLabels::paint(const QPointF& at, const QString& text, const QColor& colour) {
    if (text.isEmpty()) return;
    QPainter& painter = canvas_.painter;
    painter.setFont(textFont(canvas_, labelPt));
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(text), metrics.ascent());
    const double gap = 0.75 * markSize_;
    const double middle = at.y() - size.height() / 2, centre = at.x() - size.width() / 2;
    const std::array places{QPointF(at.x() + gap, middle), QPointF(at.x() - gap - size.width(), middle),
                            QPointF(centre, at.y() - gap - size.height()), QPointF(centre, at.y() + gap)};
    for (const QPointF& place : places) {
        const QRectF box(place, size);
        if (!isFree(box)) continue;
        taken_.push_back(box);
        painter.fillRect(box, ink::paper);  // no line crosses a label
        painter.setPen(colour);
        painter.drawText(QPointF(box.left(), box.bottom() - 0.12 * size.height()), text);
        return;
    }
}

bool PointLabels::isFree(const QRectF& box) const {
    return within_.contains(box) &&
           std::ranges::none_of(taken_, [&](const QRectF& other) { return other.intersects(box); });
}

}  // namespace noonmark
