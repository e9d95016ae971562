#include "app/report/maps/map_painter.h"

#include <QPaintEngine>
#include <algorithm>
#include <cmath>

#include "app/report/maps/city_painter.h"
#include "app/report/maps/context_painter.h"
#include "app/report/maps/map_furniture.h"
#include "app/report/maps/palette.h"

namespace noonmark {

namespace {

Box2 worldOf(const Region& region, const Grid& grid) {
    Box2 world = bounds(region);
    world.add(glm::vec2(grid.westM, grid.southM));
    world.add(glm::vec2(grid.eastM(), grid.northM()));
    return world;
}

QPainterPath pathOf(const Region& region, const MapView& view) {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    for (const Footprint& polygon : region.polygons) view.addTo(path, polygon);
    return path;
}

/// Screen pixels, or four per point in print: 288 dpi.
int wantedPixels(const Canvas& canvas, const QRectF& field) {
    const double longer = std::max(field.width(), field.height());
    const double perUnit = std::min(1.0, 4 / canvas.point);
    return int(std::ceil(longer * perUnit));
}

/// The rectangle of the picture; its last pixels may extend beyond the grid.
QRectF placeOf(const FieldImage& field, const QRectF& grid, double unitsPerCell) {
    const double pixel = unitsPerCell * field.cellsPerPixel;
    return {grid.topLeft(), QSizeF(field.image.width() * pixel, field.image.height() * pixel)};
}

/// PDF viewers blur coarse pictures, those of less than 144 dpi. Scaling by whole pixels per cell keeps edges
/// sharp.
QImage crisp(const QImage& image, const QPainter& painter, int wanted) {
    const int longer = std::max(image.width(), image.height());
    if (painter.paintEngine()->type() != QPaintEngine::Pdf || longer == 0 || 2 * longer >= wanted)
        return image;
    const int times = (wanted + longer - 1) / longer;
    return image.scaled(image.width() * times, image.height() * times);
}

void paintField(const Canvas& canvas, const MapView& view, const MapScene& scene) {
    const QRectF grid = view.rectOf(scene.grid);
    const int wanted = wantedPixels(canvas, grid);
    const FieldImage field = scene.image(wanted);
    const QRectF place = placeOf(field, grid, scene.grid.cellM * view.unitsPerM());
    canvas.painter.save();
    canvas.painter.setClipRect(grid, Qt::IntersectClip);
    canvas.painter.setRenderHint(QPainter::LosslessImageRendering);
    canvas.painter.setRenderHint(QPainter::SmoothPixmapTransform, field.image.width() > place.width());
    canvas.painter.drawImage(place, crisp(field.image, canvas.painter, wanted));
    canvas.painter.restore();
}

void paintCity(const Canvas& canvas, const MapView& view, const City& city, const QPainterPath& region) {
    paintBuildings(canvas, view, city, {ink::context, ink::contextLine});
    canvas.painter.save();
    canvas.painter.setClipPath(region, Qt::IntersectClip);
    paintBuildings(canvas, view, city, {ink::building, ink::buildingLine});
    canvas.painter.restore();
}

void paintOutline(const Canvas& canvas, const QPainterPath& region) {
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(linePen(canvas, ink::paper, 2.4));
    canvas.painter.drawPath(region);
    canvas.painter.setPen(linePen(canvas, ink::text, 0.9));
    canvas.painter.drawPath(region);
}

void paintMark(const Canvas& canvas, const QPointF& centre, const QString& text) {
    constexpr double radiusPt = 5;
    const double radius = radiusPt * canvas.point;
    const QRectF disc(centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    canvas.painter.setBrush(ink::paper);
    canvas.painter.setPen(linePen(canvas, ink::text, 0.6));
    canvas.painter.drawEllipse(disc);
    canvas.painter.setFont(textFont(canvas, 5.6, QFont::Bold));
    canvas.painter.drawText(disc, Qt::AlignCenter, text);
}

void paintMarks(const Canvas& canvas, const MapView& view, const std::vector<MapMark>& marks) {
    for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark)
        paintMark(canvas, view.at(mark->at), mark->text);
}

}  // namespace

MapScene makeMapScene(const Study& study, ShadowMeasure measure, const LegendChoice& choice) {
    const ColourScale scale = coloursOf(makeLegend(study.field, measure, choice));
    return {study.city, study.settings.region, study.field.grid, [&study, measure, scale](int wantedPixels) {
                return makeFieldImage(study.field, study.receivers, measure, scale, wantedPixels);
            }};
}

MapScene makeGrossScene(const City& city, const Region& region, const ShadowField& field,
                        const ColourScale& scale) {
    const auto image = [&field, scale](int wantedPixels) {
        const auto colour = [&](std::size_t cell) { return pickColour(scale, double(field.grossMin[cell])); };
        return makeColourImage(field.grid, colour, wantedPixels);
    };
    return {city, region, field.grid, image};
}

MapView makeMapView(const MapScene& scene, const QRectF& frame) {
    return {worldOf(scene.region, scene.grid), frame};
}

MapView makeMapView(const Study& study, const QRectF& frame) {
    return {worldOf(study.settings.region, study.field.grid), frame};
}

void paintMap(const Canvas& canvas, const MapView& view, const MapScene& scene) {
    const QPainterPath region = pathOf(scene.region, view);
    canvas.painter.save();
    canvas.painter.setClipRect(view.target());
    canvas.painter.fillRect(view.target(), ink::paper);
    if (scene.city.context)
        paintContext(canvas.painter, *scene.city.context, view.transform(), 0.4 * canvas.point);
    paintField(canvas, view, scene);
    canvas.painter.setRenderHint(QPainter::Antialiasing);
    paintCity(canvas, view, scene.city, region);
    paintOutline(canvas, region);
    paintMarks(canvas, view, scene.marks);
    canvas.painter.restore();
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(linePen(canvas, ink::line, 0.6));
    canvas.painter.drawRect(view.target());
}

void paintMap(const Canvas& canvas, const MapView& view, const Study& study, ShadowMeasure measure) {
    paintMap(canvas, view, makeMapScene(study, measure));
}

void paintMapFoot(const Canvas& canvas, const QRectF& area, const MapView& view, const Legend& legend) {
    const double point = canvas.point;
    const double arrowWidth = 16 * point;
    const double barRoom = std::min(area.width() * 0.3, 140 * point);
    const double legendWidth = area.width() - arrowWidth - barRoom - 30 * point;
    paintLegend(canvas, {area.left(), area.top(), legendWidth, area.height()}, legend);
    paintNorthArrow(canvas, {area.right() - arrowWidth, area.top(), arrowWidth, area.height()});
    const QRectF barArea(area.right() - arrowWidth - 10 * point - barRoom, area.top(), barRoom,
                         area.height());
    const double longestM = (barRoom - 20 * point) / view.unitsPerM();
    paintScaleBar(canvas, barArea, scaleBarWithin(longestM), view.unitsPerM());
}

}  // namespace noonmark
