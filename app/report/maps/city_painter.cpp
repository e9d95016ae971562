#include "app/report/maps/city_painter.h"

namespace noonmark {

namespace {

/// One path per building, for its overhangs or its other parts: the winding rule merges overlapping parts.
QPainterPath pathOf(const Building& building, const MapView& view, bool isOverhanging) {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    for (const Part& part : building.parts)
        if (part.isOverhanging == isOverhanging) view.addTo(path, part.footprint);
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
        paintOverhangs(canvas, pathOf(*building, view, true), style);
        paintSolid(canvas, pathOf(*building, view, false), style);
    }
}

}  // namespace noonmark
