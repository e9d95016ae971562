#include "app/report/maps/city_painter.h"

#include <algorithm>

#include "core/city/terrain/ground_contact.h"

namespace noonmark {

namespace {

bool standsOnGround(const Part& part, const City& city) {
    if (!part.isOverhanging || part.footprint.outer.empty()) return !part.isOverhanging;
    return reachesGround(part, groundAt(city, glm::dvec2(part.footprint.outer.front())));
}

/// One path per building, for its parts on the ground or for the rest: the winding rule merges overlapping
/// parts.
QPainterPath pathOf(const Building& building, const MapView& view, const City& city, bool standing) {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    for (const Part& part : building.parts)
        if (standsOnGround(part, city) == standing) view.addTo(path, part.footprint);
    return path;
}

void paintSolid(const Canvas& canvas, const QPainterPath& path, const FootprintStyle& style) {
    if (path.isEmpty()) return;
    canvas.painter.setBrush(style.fill);
    canvas.painter.setPen(linePen(canvas, style.line, style.linePt));
    canvas.painter.drawPath(path);
}

void paintOverhangs(const Canvas& canvas, const QPainterPath& path, const FootprintStyle& style) {
    if (path.isEmpty()) return;
    QPen pen = linePen(canvas, style.line, 2 * style.linePt);
    pen.setDashPattern({4, 3});
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(pen);
    canvas.painter.drawPath(path);
}

}  // namespace

void paintBuildings(const Canvas& canvas, const MapView& view, const City& city,
                    const FootprintStyle& style) {
    for (const auto& building : city.buildings) {
        if (!view.sees(bounds(*building))) continue;
        paintOverhangs(canvas, pathOf(*building, view, city, false), style);
        paintSolid(canvas, pathOf(*building, view, city, true), style);
    }
}

bool showsOverhangs(const MapView& view, const City& city) {
    const auto isOpen = [&](const Part& part) { return !standsOnGround(part, city); };
    return std::ranges::any_of(city.buildings, [&](const auto& building) {
        return view.sees(bounds(*building)) && std::ranges::any_of(building->parts, isOpen);
    });
}

}  // namespace noonmark
