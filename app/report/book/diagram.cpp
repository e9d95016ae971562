#include "app/report/book/diagram.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/report/book/paper.h"
#include "app/report/maps/city_painter.h"
#include "app/report/maps/map_view.h"
#include "app/report/sheets/study_text.h"

namespace noonmark {

namespace {

constexpr double heightLabelPt = 4.6;
constexpr double nameLabelPt = 6.6;
constexpr double streetLabelPt = 5;
constexpr double maxScaleOfHeights = 2500;  // beyond, numbers would cover the map

QPainterPath pathOf(const std::vector<Footprint>& polygons, const MapView& view) {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    for (const Footprint& polygon : polygons)
        if (view.sees(bounds(polygon))) view.addTo(path, polygon);
    return path;
}

/// Paints one diagram; keeps the rectangles of its labels so that they do not cover each other.
class DiagramPainter {
public:
    DiagramPainter(const Canvas& canvas, const QRectF& map, const Diagram& diagram)
        : canvas_(canvas),
          diagram_(diagram),
          scene_(*diagram.scene),
          view_(diagram.centre, pointsPerMetre(diagram.scale) * canvas.point, map) {}

    void paint() {
        QPainter& painter = canvas_.painter;
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setClipRect(view_.target());
        painter.fillRect(view_.target(), ink::paper);
        paintGround();
        paintStreetLines();
        paintBuildings(canvas_, view_, scene_.city, {shade::building, shade::buildingLine, 0.25});
        paintRemoved();
        paintFan();
        paintBuildings(canvas_, view_, scene_.proposal, {shade::proposal, ink::text, 0.9});
        paintPlaceLines();
        paintValueLines();
        paintFanTimes();
        paintPlaceNames();
        paintStreetNames();
        paintHeights(scene_.proposal, ink::paper, true);
        if (diagram_.scale <= maxScaleOfHeights) paintHeights(scene_.city, ink::quiet, false);
        painter.restore();
        painter.setBrush(Qt::NoBrush);
        painter.setPen(linePen(canvas_, ink::quiet, 0.6));
        painter.drawRect(view_.target());
    }

private:
    void fill(const QPainterPath& path, const QColor& colour) {
        if (!path.isEmpty()) canvas_.painter.fillPath(path, colour);
    }

    void paintGround() {
        if (scene_.city.context)
            paintContext(canvas_.painter, *scene_.city.context, view_.transform(), 0.4 * canvas_.point);
        for (const Place& place : scene_.places) fill(pathOf(place.polygons, view_), shade::place);
        fill(pathOf(diagram_.shadows.baseline, view_), shade::baseline);
        fill(pathOf(diagram_.shadows.gained, view_), shade::gained);
        fill(pathOf(diagram_.shadows.incremental, view_), shade::incremental);
    }

    /// Above other buildings, which do not hide it.
    void paintFan() {
        QColor pale = shade::incremental;
        pale.setAlpha(56);
        canvas_.painter.setBrush(pale);
        canvas_.painter.setPen(linePen(canvas_, shade::incremental, 0.6));
        for (const FanShadow& shadow : diagram_.fan) canvas_.painter.drawPath(pathOf(shadow.polygons, view_));
    }

    /// A label with a white plate, where no other label is.
    void paintMark(QPointF at, const QString& text, const QColor& colour) {
        const QFont font = textFont(canvas_, nameLabelPt * 0.9 * diagram_.textScale, QFont::Medium);
        const QFontMetricsF metrics(font, canvas_.painter.device());
        QRectF box(0, 0, metrics.horizontalAdvance(text) + 2 * canvas_.point,
                   metrics.capHeight() + 3 * canvas_.point);
        box.moveCenter(at);
        box = inside(box, 2 * canvas_.point);
        if (!isFree(box)) return;
        labels_.push_back(box);
        canvas_.painter.fillRect(box, QColor(255, 255, 255, 225));
        canvas_.painter.setFont(font);
        canvas_.painter.setPen(colour);
        canvas_.painter.drawText(QPointF(box.left() + canvas_.point, box.bottom() - 1.5 * canvas_.point),
                                 text);
    }

    /// Each at the point of its shadow that is farthest from the proposal.
    void paintFanTimes() {
        Box2 box;
        for (const auto& building : scene_.proposal.buildings) box.add(bounds(*building));
        if (box.empty()) return;
        const glm::vec2 foot = (box.low + box.high) / 2.0F;
        for (const FanShadow& shadow : diagram_.fan) {
            glm::vec2 tip = foot;
            for (const Footprint& polygon : shadow.polygons)
                for (const glm::vec2 point : polygon.outer)
                    if (glm::distance(point, foot) > glm::distance(tip, foot)) tip = point;
            if (tip != foot)
                paintMark(view_.at(glm::dvec2(tip)), shadow.time, shade::incremental.darker(130));
        }
    }

    void paintValueLines() {
        canvas_.painter.setBrush(Qt::NoBrush);
        for (const ValueLine& value : diagram_.valueLines) {
            QPen pen = linePen(canvas_, value.isDistance ? ink::text : shade::incremental,
                               value.isLimit ? 1.8 : 0.9);
            if (value.isDistance) pen.setDashPattern({4, 2});
            for (const auto& line : value.lines) {
                QPolygonF points;
                for (const glm::dvec2 point : line) points << view_.at(point);
                canvas_.painter.setPen(pen);
                canvas_.painter.drawPolyline(points);
            }
            paintValueMarks(value);
        }
    }

    /// On every line of a value, the longest first, so that islands are named, too. Lines that are smaller
    /// than a mark have none, unless their value has no other.
    void paintValueMarks(const ValueLine& value) {
        std::vector<const std::vector<glm::dvec2>*> lines;
        for (const auto& line : value.lines)
            if (!line.empty()) lines.push_back(&line);
        std::ranges::sort(lines, [](const auto* a, const auto* b) { return a->size() > b->size(); });
        for (const auto* line : lines) {
            QPolygonF points;
            for (const glm::dvec2 point : *line) points << view_.at(point);
            const QRectF seen = points.boundingRect();
            const bool isSmall =
                std::max(seen.width(), seen.height()) < 12 * diagram_.textScale * canvas_.point;
            if (isSmall && line != lines.front()) continue;
            const auto farthest = std::ranges::max_element(
                *line, {}, [&](glm::dvec2 point) { return glm::distance(point, diagram_.centre); });
            paintMark(view_.at(*farthest), value.label,
                      value.isDistance ? ink::text : shade::incremental.darker(130));
        }
    }

    void paintRemoved() {
        QPen pen = linePen(canvas_, ink::text, 0.6);
        pen.setDashPattern({3, 2});
        canvas_.painter.setPen(pen);
        canvas_.painter.setBrush(Qt::NoBrush);
        for (const auto& building : scene_.removed.buildings)
            for (const Part& part : building->parts)
                canvas_.painter.drawPath(pathOf({part.footprint}, view_));
    }

    void paintPlaceLines() {
        canvas_.painter.setBrush(Qt::NoBrush);
        for (std::size_t i = 0; i < scene_.places.size(); ++i)
            paintPlaceLine(pathOf(scene_.places[i].polygons, view_),
                           scene_.placeColours.empty() ? QColor() : scene_.placeColours[i]);
    }

    /// A light colour is seen on paper by the dark line below it.
    void paintPlaceLine(const QPainterPath& path, const QColor& colour) {
        const QColor below = colour.isValid() ? ink::text : shade::placeLine;
        canvas_.painter.setPen(linePen(canvas_, below, colour.isValid() ? 2.2 : 1.1));
        canvas_.painter.drawPath(path);
        if (!colour.isValid()) return;
        canvas_.painter.setPen(linePen(canvas_, colour, 1.5));
        canvas_.painter.drawPath(path);
    }

    void paintStreetLines() {
        canvas_.painter.setBrush(Qt::NoBrush);
        canvas_.painter.setPen(linePen(canvas_, ink::paper, 0.5));
        for (const Place& street : scene_.streets) canvas_.painter.drawPath(pathOf(street.polygons, view_));
    }

    /// Along each street, where there is room for its name and no other label.
    void paintStreetNames() {
        const QFont font = textFont(canvas_, streetLabelPt * diagram_.textScale);
        const QFontMetricsF metrics(font, canvas_.painter.device());
        canvas_.painter.setFont(font);
        canvas_.painter.setPen(ink::text);
        for (const Place& street : scene_.streets) {
            const auto spot = findStreetNameSpot(street, view_);
            const QString name = plainText(street.name);
            const double width = metrics.horizontalAdvance(name);
            if (!spot || width > spot->room) continue;
            const QRectF text(-width / 2, -metrics.capHeight() / 2, width, metrics.capHeight());
            const QTransform along =
                QTransform::fromTranslate(spot->middle.x(), spot->middle.y()).rotate(spot->angleDeg);
            const QRectF box = along.mapRect(text);
            if (!isFree(box) || !view_.target().contains(box)) continue;
            labels_.push_back(box);
            canvas_.painter.save();
            canvas_.painter.setTransform(along, true);
            canvas_.painter.drawText(text.bottomLeft(), name);
            canvas_.painter.restore();
        }
    }

    [[nodiscard]] bool isFree(const QRectF& box) const {
        return std::ranges::none_of(labels_, [&](const QRectF& label) { return label.intersects(box); });
    }

    /// Inside each place, the smallest numbers first; many pieces with one number have it where there is
    /// room.
    void paintPlaceNumbers() {
        std::vector<std::pair<int, QPointF>> marks;
        for (std::size_t i = 0; i < scene_.places.size(); ++i) {
            if (scene_.numbers[i] == 0) continue;
            const QPainterPath path = pathOf(scene_.places[i].polygons, view_);
            const QRectF seen = path.boundingRect().intersected(view_.target());
            if (!seen.isEmpty()) marks.emplace_back(scene_.numbers[i], middleOf(path, seen));
        }
        std::ranges::stable_sort(marks, {}, &std::pair<int, QPointF>::first);
        for (const auto& [number, at] : marks) paintMark(at, QString::number(number), shade::placeLine);
    }

    /// A point of the path: the middle of its widest piece on the middle line of what is seen.
    static QPointF middleOf(const QPainterPath& path, const QRectF& seen) {
        constexpr int steps = 24;
        int best = 0, run = 0, end = -1;
        for (int i = 0; i < steps; ++i) {
            run = path.contains(QPointF(seen.left() + seen.width() * (i + 0.5) / steps, seen.center().y()))
                      ? run + 1
                      : 0;
            if (run > best) best = run, end = i;
        }
        if (end < 0) return seen.center();
        return {seen.left() + seen.width() * (end + 1 - best / 2.0) / steps, seen.center().y()};
    }

    /// In the middle of what is seen of each place, moved up or down where another label is.
    void paintPlaceNames() {
        if (!scene_.numbers.empty()) return paintPlaceNumbers();
        for (const Place& place : scene_.places) {
            const QRectF seen = pathOf(place.polygons, view_).boundingRect().intersected(view_.target());
            if (seen.isEmpty()) continue;
            paintName(plainText(place.name), seen);
        }
    }

    void paintName(const QString& name, const QRectF& seen) {
        const QFont font = textFont(canvas_, nameLabelPt * diagram_.textScale, QFont::Medium);
        const double margin = 3 * canvas_.point;
        const double maximum = std::min(view_.target().width() - 2 * margin,
                                        std::max(seen.width(), 110 * diagram_.textScale * canvas_.point));
        const double natural = QFontMetricsF(font, canvas_.painter.device()).horizontalAdvance(name) * 1.02;
        const double width = std::min(maximum, natural);
        const double height = textHeight(canvas_, name, font, width);
        QRectF box(0, 0, width, height);
        for (const double shift : {0.0, 1.1, -1.1, 2.2, -2.2, 3.3, -3.3}) {
            box.moveCenter(seen.center() + QPointF(0, shift * height));
            box = inside(box, margin);
            if (isFree(box)) break;
        }
        if (!isFree(box) || height > view_.target().height() / 2) return;
        labels_.push_back(box);
        const QRectF plate = box.adjusted(-1.5 * canvas_.point, 0, 1.5 * canvas_.point, 0);
        canvas_.painter.fillRect(plate, QColor(255, 255, 255, 215));
        paintLines(canvas_, box, name, font, shade::placeLine, Qt::AlignHCenter);
    }

    [[nodiscard]] QRectF inside(QRectF box, double margin) const {
        const QRectF room = view_.target().adjusted(margin, margin, -margin, -margin);
        box.moveLeft(std::clamp(box.left(), room.left(), std::max(room.left(), room.right() - box.width())));
        box.moveTop(std::clamp(box.top(), room.top(), std::max(room.top(), room.bottom() - box.height())));
        return box;
    }

    /// Of the proposal with its unit; of other buildings the number alone, whose unit the foot states.
    [[nodiscard]] QString heightText(double metres, bool isProposal) const {
        if (isProposal) return QString::fromStdString(formatLength(metres, scene_.units, 0));
        const double unitM = scene_.units == UnitSystem::imperial ? metresPerFoot : 1;
        return QString::number(std::round(metres / unitM));
    }

    /// Heights above the ground, where the number lies inside the footprint.
    void paintHeights(const City& city, const QColor& colour, bool isBold) {
        const double size = heightLabelPt * diagram_.textScale * (isBold ? 1.25 : 1);
        const QFont font = textFont(canvas_, size, isBold ? QFont::Bold : QFont::Normal);
        const QFontMetricsF metrics(font, canvas_.painter.device());
        canvas_.painter.setFont(font);
        canvas_.painter.setPen(colour);
        for (const auto& building : city.buildings) {
            const Box2 box = bounds(*building);
            if (box.empty() || !view_.sees(box)) continue;
            const glm::dvec2 middle = glm::dvec2(box.low + box.high) / 2.0;
            const QString text = heightText(topM(*building) - groundAt(city, middle), isBold);
            const double width = metrics.horizontalAdvance(text);
            QRectF label(0, 0, width, metrics.capHeight());
            label.moveCenter(view_.at(middle));
            if (width > double(box.high.x - box.low.x) * view_.unitsPerM() || !isFree(label)) continue;
            if (!view_.target().contains(label) || !covers(*building, label)) continue;
            canvas_.painter.drawText(label.bottomLeft(), text);
            labels_.push_back(label);
        }
    }

    [[nodiscard]] bool covers(const Building& building, const QRectF& label) const {
        QPainterPath path;
        path.setFillRule(Qt::WindingFill);
        for (const Part& part : building.parts) view_.addTo(path, part.footprint);
        return path.contains(label);
    }

    Canvas canvas_;
    const Diagram& diagram_;
    const DiagramScene& scene_;
    MapView view_;
    std::vector<QRectF> labels_;
};

}  // namespace

QRectF mapAreaOf(const QRectF& area, double textScale) {
    return area.adjusted(0, 0, 0, -captionPt(textScale));
}

Box2 groundOf(glm::dvec2 centre, double scale, const QRectF& map) {
    const glm::dvec2 half = glm::dvec2(map.width(), map.height()) / pointsPerMetre(scale) / 2.0;
    return {glm::vec2(centre - half), glm::vec2(centre + half)};
}

void paintDiagram(const Canvas& canvas, const QRectF& area, const Diagram& diagram) {
    const double caption = captionPt(diagram.textScale) * canvas.point;
    DiagramPainter(canvas, area.adjusted(0, 0, 0, -caption), diagram).paint();
    paintCaption(canvas, {area.left(), area.bottom() - caption, area.width(), caption}, diagram.caption,
                 diagram.textScale);
}

}  // namespace noonmark
