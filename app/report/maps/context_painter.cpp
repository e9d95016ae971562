#include "app/report/maps/context_painter.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

constexpr double treeRadiusM = 2.5;

QColor colourOf(ContextKind kind) {
    switch (kind) {
        case ContextKind::wood:
            return {0xbf, 0xd6, 0xb0};
        case ContextKind::grass:
            return {0xd9, 0xe8, 0xcb};
        case ContextKind::park:
            return {0xcd, 0xe2, 0xbd};
        case ContextKind::cemetery:
            return {0xcf, 0xdb, 0xc8};
        case ContextKind::sports:
            return {0xd2, 0xdf, 0xc4};
        case ContextKind::plaza:
            return {0xee, 0xeb, 0xe4};
        case ContextKind::water:
        case ContextKind::waterway:
            return {0xb4, 0xd2, 0xe4};
        case ContextKind::path:
            return {0xf0, 0xea, 0xdc};
        case ContextKind::rail:
            return {0xa9, 0xa9, 0xae};
        case ContextKind::street:
            return {0xfd, 0xfd, 0xfc};
        case ContextKind::tree:
            return {0x86, 0xb0, 0x78, 150};
    }
    return {};
}

QPolygonF polygonOf(const std::vector<glm::vec2>& points, const QTransform& toPainter) {
    QPolygonF polygon;
    for (const glm::vec2 point : points) polygon << QPointF(double(point.x), double(point.y));
    return toPainter.map(polygon);
}

double unitsPerMetre(const QTransform& toPainter) { return std::sqrt(std::abs(toPainter.determinant())); }

void paintAreas(QPainter& painter, const MapContext& context, ContextKind kind, const QTransform& toPainter) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colourOf(kind));
    for (const ContextArea& area : context.areas) {
        if (area.kind != kind) continue;
        QPainterPath path;  // odd-even: holes stay free
        for (const Footprint& polygon : area.polygons) {
            path.addPolygon(polygonOf(polygon.outer, toPainter));
            for (const Ring& hole : polygon.holes) path.addPolygon(polygonOf(hole, toPainter));
        }
        painter.drawPath(path);
    }
}

void paintLines(QPainter& painter, const MapContext& context, ContextKind kind, const QTransform& toPainter,
                double leastLine) {
    painter.setBrush(Qt::NoBrush);
    const double perMetre = unitsPerMetre(toPainter);
    for (const ContextLine& line : context.lines) {
        if (line.kind != kind) continue;
        painter.setPen(QPen(colourOf(kind), std::max(leastLine, double(line.widthM) * perMetre),
                            Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(polygonOf(line.points, toPainter));
    }
}

void paintTrees(QPainter& painter, const MapContext& context, const QTransform& toPainter, double leastLine) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colourOf(ContextKind::tree));
    const double radius = std::max(leastLine, treeRadiusM * unitsPerMetre(toPainter));
    for (const glm::vec2 tree : context.trees)
        painter.drawEllipse(toPainter.map(QPointF(double(tree.x), double(tree.y))), radius, radius);
}

}  // namespace

void paintContext(QPainter& painter, const MapContext& context, const QTransform& toPainter,
                  double leastLine) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const ContextKind kind : contextKinds) paintAreas(painter, context, kind, toPainter);
    for (const ContextKind kind : contextKinds) paintLines(painter, context, kind, toPainter, leastLine);
    paintTrees(painter, context, toPainter, leastLine);
    painter.restore();
}

}  // namespace noonmark
