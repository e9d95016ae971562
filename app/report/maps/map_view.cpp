#include "app/report/maps/map_view.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "app/report/maps/sheet_text.h"

namespace noonmark {

namespace {
constexpr double marginShare = 0.04;
constexpr double minSizeM = 1;  // an empty region still gets a view

glm::dvec2 sizeOf(const Box2& world) {
    return glm::max(glm::dvec2(world.high - world.low), glm::dvec2(minSizeM));
}
}  // namespace

MapView::MapView(const Box2& world, const QRectF& target)
    : target_(target), centre_((glm::dvec2(world.low) + glm::dvec2(world.high)) / 2.0) {
    const glm::dvec2 shown = sizeOf(world) * (1 + 2 * marginShare);
    unitsPerM_ = std::min(target.width() / shown.x, target.height() / shown.y);
}

QPointF MapView::at(glm::dvec2 local) const {
    const glm::dvec2 offset = (local - centre_) * unitsPerM_;
    return target_.center() + QPointF(offset.x, -offset.y);
}

QTransform MapView::transform() const {
    const QPointF origin = at({0, 0});
    return {unitsPerM_, 0, 0, -unitsPerM_, origin.x(), origin.y()};
}

QRectF MapView::rectOf(const Grid& grid) const {
    return {at({grid.westM, grid.northM()}), at({grid.eastM(), grid.southM})};
}

bool MapView::sees(const Box2& box) const {
    const QRectF shown = QRectF(at({box.low.x, box.high.y}), at({box.high.x, box.low.y}));
    return shown.left() <= target_.right() && shown.right() >= target_.left() &&
           shown.top() <= target_.bottom() && shown.bottom() >= target_.top();
}

void MapView::addTo(QPainterPath& path, const Footprint& footprint) const {
    const auto addRing = [&](const Ring& ring) {
        if (ring.empty()) return;
        path.moveTo(at(glm::dvec2(ring.front())));
        for (std::size_t i = 1; i < ring.size(); ++i) path.lineTo(at(glm::dvec2(ring[i])));
        path.closeSubpath();
    };
    addRing(footprint.outer);
    for (const Ring& hole : footprint.holes) addRing(hole);
}

double aspectOf(const Box2& world) {
    const glm::dvec2 size = sizeOf(world);
    return std::clamp(size.x / size.y, 0.5, 2.0);
}

namespace {

constexpr double labelPt = 7.5;
constexpr double barPt = 3.5;

constexpr double metresPerMile = 5280 * metresPerFoot;

/// The number at the end of the bar and its unit.
struct BarLabel {
    QString number, unit;
};

BarLabel labelOf(const ScaleBar& bar) {
    const double metres = bar.lengthM();
    const bool isLong = metres >= (bar.inFeet ? metresPerMile : 2000);
    const double unitM = bar.inFeet ? (isLong ? metresPerMile : metresPerFoot) : (isLong ? 1000 : 1);
    const char* unit = bar.inFeet ? (isLong ? NM_TEXT(" mi") : NM_TEXT(" ft")) : (isLong ? " km" : " m");
    return {shortNumber(metres / unitM, 6), sheetText(unit)};
}

/// The longest round bar of at most `longest` units, each of `unitM` metres.
ScaleBar roundBar(double longest, double unitM) {
    const double decade = std::pow(10, std::floor(std::log10(longest)));
    if (5 * decade <= longest) return {decade * unitM, 5};
    if (2 * decade <= longest) return {decade * unitM, 2};
    return {decade / 2 * unitM, 2};
}

void paintLabel(const Canvas& canvas, double x, double baseline, const QString& label) {
    const double width = QFontMetricsF(canvas.painter.font()).horizontalAdvance(label);
    canvas.painter.drawText(QPointF(x - width / 2, baseline), label);
}

void paintFields(const Canvas& canvas, const QRectF& bar, int parts) {
    canvas.painter.setPen(linePen(canvas, canvas.inks.text, 0.5));
    for (int i = 0; i < parts; ++i) {
        canvas.painter.setBrush(i % 2 == 0 ? canvas.inks.text : canvas.inks.paper);
        canvas.painter.drawRect(
            QRectF(bar.left() + bar.width() * i / parts, bar.top(), bar.width() / parts, bar.height()));
    }
}

}  // namespace

ScaleBar scaleBarWithin(double longestM, UnitSystem units) {
    if (units != UnitSystem::imperial) return roundBar(longestM, 1);
    const double unitM = longestM >= metresPerMile ? metresPerMile : metresPerFoot;
    ScaleBar bar = roundBar(longestM / unitM, unitM);
    bar.inFeet = true;
    return bar;
}

void paintScaleBar(const Canvas& canvas, const QRectF& area, const ScaleBar& scale, double unitsPerM) {
    const double length = scale.lengthM() * unitsPerM;
    const auto [number, unit] = labelOf(scale);
    canvas.painter.save();
    canvas.painter.setRenderHint(QPainter::Antialiasing);
    canvas.painter.setFont(textFont(canvas, labelPt));
    const double endLabel = QFontMetricsF(canvas.painter.font()).horizontalAdvance(number + unit);
    const QRectF bar(area.right() - endLabel / 2 - length, area.top() + 13 * canvas.point, length,
                     barPt * canvas.point);
    paintFields(canvas, bar, scale.parts);
    canvas.painter.setPen(canvas.inks.text);
    const double baseline = bar.top() - 3 * canvas.point;
    paintLabel(canvas, bar.left(), baseline, QStringLiteral("0"));
    paintLabel(canvas, bar.right(), baseline, number + unit);
    canvas.painter.restore();
}

void paintNorthArrow(const Canvas& canvas, const QRectF& area) {
    const double point = canvas.point;
    const QPointF tip(area.center().x(), area.top() + 9 * point);
    QPainterPath west(tip);
    west.lineTo(tip + QPointF(-5 * point, 17 * point));
    west.lineTo(tip + QPointF(0, 13 * point));
    west.closeSubpath();
    QPainterPath east(tip);
    east.lineTo(tip + QPointF(5 * point, 17 * point));
    east.lineTo(tip + QPointF(0, 13 * point));
    east.closeSubpath();
    canvas.painter.save();
    canvas.painter.setRenderHint(QPainter::Antialiasing);
    canvas.painter.setPen(linePen(canvas, canvas.inks.text, 0.5));
    canvas.painter.fillPath(west, canvas.inks.text);
    canvas.painter.setBrush(canvas.inks.paper);
    canvas.painter.drawPath(east);
    canvas.painter.setFont(textFont(canvas, labelPt, QFont::Bold));
    canvas.painter.setPen(canvas.inks.text);
    paintLabel(canvas, tip.x(), area.top() + 6.5 * point, QStringLiteral("N"));
    canvas.painter.restore();
}

}  // namespace noonmark
