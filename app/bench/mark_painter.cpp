#include "app/bench/mark_painter.h"

#include <QPolygonF>
#include <cmath>
#include <numbers>

#include "app/report/maps/style.h"

namespace noonmark {

namespace {

// A regular polygon with a corner at the top if `turn` is 0; `turn` is a share of the full circle.
QPainterPath polygonPath(int corners, double radius, double turn = 0) {
    QPolygonF polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (double(i) / corners + turn);
        polygon << QPointF(radius * std::sin(angle), -radius * std::cos(angle));
    }
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
}

}  // namespace

QPainterPath markPath(MarkShape shape, double size) {
    const double radius = size / 2;
    switch (shape) {
        case MarkShape::square:
            return polygonPath(4, radius * 1.2, 0.125);
        case MarkShape::triangle:
            return polygonPath(3, radius * 1.25);
        case MarkShape::diamond:
            return polygonPath(4, radius * 1.25);
        case MarkShape::pentagon:
            return polygonPath(5, radius * 1.15);
        case MarkShape::circle:
            break;
    }
    QPainterPath path;
    path.addEllipse(QPointF(0, 0), radius, radius);
    return path;
}

void paintMark(QPainter& painter, const QPointF& at, const ChartInk& look, bool hollow, double size,
               double line) {
    painter.setPen(QPen(hollow ? look.colour : ink::paper, line));
    painter.setBrush(hollow ? ink::paper : look.colour);
    painter.drawPath(markPath(look.shape, size).translated(at));
    painter.setBrush(Qt::NoBrush);  // later lines must not be filled
}

}  // namespace noonmark
