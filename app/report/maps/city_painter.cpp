#include "app/report/maps/city_painter.h"

#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/city/building_heights.h"
#include "core/city/terrain/building_ground.h"

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

void paintSolid(const Canvas& canvas, const QPainterPath& path, const FootprintStyle& style,
                const Building& building) {
    if (path.isEmpty()) return;
    canvas.painter.setBrush(style.fillOf ? style.fillOf(building) : style.fill);
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

FootprintStyle withProposals(FootprintStyle style) {
    style.fillOf = [fill = style.fill](const Building& building) {
        return isProposal(building) ? shade::proposal : fill;
    };
    return style;
}

void paintBuildings(const Canvas& canvas, const MapView& view, const City& city,
                    const FootprintStyle& style) {
    for (const auto& building : city.buildings) {
        if (!view.sees(bounds(*building))) continue;
        paintOverhangs(canvas, pathOf(*building, view, city, false), style);
        paintSolid(canvas, pathOf(*building, view, city, true), style, *building);
    }
}

bool showsOverhangs(const MapView& view, const City& city) {
    const auto isOpen = [&](const Part& part) { return !standsOnGround(part, city); };
    return std::ranges::any_of(city.buildings, [&](const auto& building) {
        return view.sees(bounds(*building)) && std::ranges::any_of(building->parts, isOpen);
    });
}

namespace {

constexpr double treeRadiusM = 2.5;

QColor colourOf(ContextKind kind) {
    switch (kind) {
        case ContextKind::wood:
            return {0xbf, 0xd6, 0xb0};
        case ContextKind::grass:
            return {0xdc, 0xe9, 0xcf};
        case ContextKind::park:
            return {0xcf, 0xe3, 0xc0};
        case ContextKind::cemetery:
            return {0xcf, 0xdb, 0xc8};
        case ContextKind::sports:
            return {0xd2, 0xdf, 0xc4};
        case ContextKind::plaza:
            return {0xe6, 0xe2, 0xd8};
        case ContextKind::water:
        case ContextKind::waterway:
            return {0xa8, 0xcb, 0xe0};
        case ContextKind::path:
            return {0xe3, 0xdd, 0xcf};
        case ContextKind::rail:
            return {0xa9, 0xa9, 0xae};
        case ContextKind::street:
            return {0xd9, 0xd9, 0xd8};
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

/// What lies outside the painter's clip is not painted: it would fill files of vectors, although nobody sees
/// it.
class VisibleFeatures {
public:
    VisibleFeatures(const QPainter& painter, const QTransform& toPainter)
        : toPainter_(toPainter), clip_(painter.clipBoundingRect()), isAll_(!painter.hasClipping()) {}

    /// Whether anything of these points, widened by `margin` painter units, may be seen.
    [[nodiscard]] bool sees(const std::vector<glm::vec2>& points, double margin = 0) const {
        if (isAll_ || points.empty()) return isAll_;
        Box2 box;
        for (const glm::vec2 point : points) box.add(point);
        const QRectF local(double(box.low.x), double(box.low.y), double(box.high.x) - double(box.low.x),
                           double(box.high.y) - double(box.low.y));
        // Not QRectF::intersects(): a street along an axis has no area.
        const QRectF seen = toPainter_.mapRect(local).adjusted(-margin, -margin, margin, margin);
        return seen.left() <= clip_.right() && clip_.left() <= seen.right() && seen.top() <= clip_.bottom() &&
               clip_.top() <= seen.bottom();
    }

private:
    QTransform toPainter_;
    QRectF clip_;
    bool isAll_;
};

void paintAreas(QPainter& painter, const MapContext& context, ContextKind kind, const QTransform& toPainter) {
    const VisibleFeatures visible(painter, toPainter);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colourOf(kind));
    for (const ContextArea& area : context.areas) {
        if (area.kind != kind) continue;
        QPainterPath path;  // odd-even: holes stay free
        for (const Footprint& polygon : area.polygons) {
            if (!visible.sees(polygon.outer)) continue;
            path.addPolygon(polygonOf(polygon.outer, toPainter));
            for (const Ring& hole : polygon.holes) path.addPolygon(polygonOf(hole, toPainter));
        }
        if (!path.isEmpty()) painter.drawPath(path);
    }
}

void paintLines(QPainter& painter, const MapContext& context, ContextKind kind, const QTransform& toPainter,
                double minLine) {
    const VisibleFeatures visible(painter, toPainter);
    painter.setBrush(Qt::NoBrush);
    const double perMetre = unitsPerMetre(toPainter);
    for (const ContextLine& line : context.lines) {
        const double width = std::max(minLine, double(line.widthM) * perMetre);
        if (line.kind != kind || !visible.sees(line.points, width / 2)) continue;
        painter.setPen(QPen(colourOf(kind), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(polygonOf(line.points, toPainter));
    }
}

void paintTrees(QPainter& painter, const MapContext& context, const QTransform& toPainter, double minLine) {
    const VisibleFeatures visible(painter, toPainter);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colourOf(ContextKind::tree));
    const double radius = std::max(minLine, treeRadiusM * unitsPerMetre(toPainter));
    for (const glm::vec2 tree : context.trees)
        if (visible.sees({tree}, radius))
            painter.drawEllipse(toPainter.map(QPointF(double(tree.x), double(tree.y))), radius, radius);
}

// The part of the raster that the painter shows, in the raster's pixels.
QRect visiblePart(const QPainter& painter, const Grid& grid, const QTransform& fromPainter) {
    const QRect whole(0, 0, grid.columns, grid.rows);
    if (!painter.hasClipping()) return whole;
    const QRectF seen = fromPainter.mapRect(painter.clipBoundingRect());
    return seen.toAlignedRect().adjusted(-1, -1, 1, 1).intersected(whole);
}

// Row 0 of the image is the southernmost, as in the grid: the transform turns it over where north is up.
void paintPicture(QPainter& painter, const ContextPicture& picture, const QTransform& toPainter) {
    constexpr int maxPixels = 4096;
    const Grid& grid = picture.raster->grid;
    const QImage whole(picture.raster->rgba.data(), grid.columns, grid.rows, grid.columns * 4,
                       QImage::Format_RGBA8888);
    const QTransform placed = QTransform(grid.cellM, 0, 0, grid.cellM, grid.westM, grid.southM) * toPainter;
    const QRect part = visiblePart(painter, grid, placed.inverted());
    if (part.isEmpty()) return;
    QImage image = part == whole.rect() ? whole : whole.copy(part);
    if (std::max(part.width(), part.height()) > maxPixels)
        image = image.scaled(maxPixels, maxPixels, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setOpacity(picture.opacity);
    painter.setTransform(placed, true);
    painter.drawImage(QRectF(part), image);
}

}  // namespace

void paintContext(QPainter& painter, const MapContext& context, const QTransform& toPainter, double minLine,
                  bool withTrees) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const ContextKind kind : contextKinds) paintAreas(painter, context, kind, toPainter);
    for (const ContextKind kind : contextKinds) paintLines(painter, context, kind, toPainter, minLine);
    if (withTrees) paintTrees(painter, context, toPainter, minLine);
    if (context.picture) paintPicture(painter, *context.picture, toPainter);
    painter.restore();
}

}  // namespace noonmark
