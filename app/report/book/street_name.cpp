#include "app/report/book/diagram.h"

#include <QLineF>
#include <cmath>
#include <glm/geometric.hpp>

namespace noonmark {

namespace {

double lengthOf(const Ring& ring) {
    double length = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        length += double(glm::distance(ring[i], ring[(i + 1) % ring.size()]));
    return length;
}

// A strip's area is its length times its width, and its outline is two lengths and two widths.
double widthOf(const Footprint& strip) {
    const double half = lengthOf(strip.outer) / 2, root = half * half - 4 * area(strip);
    return root <= 0 ? half / 2 : (half - std::sqrt(root)) / 2;
}

/// The part of a line in a rectangle (Liang and Barsky); a null line where they do not meet.
QLineF clip(const QLineF& line, const QRectF& to) {
    double first = 0, last = 1;
    const auto cut = [&](double from, double along, double low, double high) {
        if (along == 0) return from >= low && from <= high;
        const double a = (low - from) / along, b = (high - from) / along;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
        return first < last;
    };
    const bool meets =
        cut(line.x1(), line.dx(), to.left(), to.right()) && cut(line.y1(), line.dy(), to.top(), to.bottom());
    return meets ? QLineF(line.pointAt(first), line.pointAt(last)) : QLineF();
}

}  // namespace

std::optional<StreetNameSpot> findStreetNameSpot(const Place& street, const MapView& view) {
    QLineF longest;
    double inward = 0;  // half the street's width, painter units
    for (const Footprint& polygon : street.polygons) {
        if (!view.sees(bounds(polygon))) continue;
        const Ring& ring = polygon.outer;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const QLineF side(view.at(glm::dvec2(ring[i])), view.at(glm::dvec2(ring[(i + 1) % ring.size()])));
            const QLineF seen = clip(side, view.target());
            if (seen.length() <= longest.length()) continue;
            longest = seen;
            inward = widthOf(polygon) / 2 * view.unitsPerM();
        }
    }
    if (longest.length() == 0) return std::nullopt;
    // Outlines run counter-clockwise: the street is to the left, which is upwards for a line to the right.
    const QPointF left(longest.dy() / longest.length(), -longest.dx() / longest.length());
    double angle = -longest.angle();
    if (angle < -90) angle += 180;
    if (angle < -90) angle += 180;
    return StreetNameSpot{longest.center() + inward * left, angle, longest.length()};
}

}  // namespace noonmark
