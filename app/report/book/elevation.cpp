#include "app/report/book/elevation.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/book/paper.h"
#include "app/report/maps/sheet_text.h"

namespace noonmark {

namespace {

constexpr std::array elevationScales{50.0,   100.0,  150.0,  200.0,  250.0,   300.0,
                                     400.0,  500.0,  750.0,  1000.0, 1250.0,  1500.0,
                                     2000.0, 2500.0, 4000.0, 5000.0, 10000.0, 20000.0};
constexpr double titlePt = 10, floorsPt = 13, panelGapPt = 6, panelMarginPt = 3;
constexpr double minStoreyTextPt = 5.5;
const QColor wallColour(0xf4, 0xf4, 0xf5), wallLine(0x85, 0x88, 0x90);

/// What is left for the picture of one panel, points.
QSizeF roomOf(const QSizeF& areaPt, std::size_t panels, bool stacked, double textScale) {
    const auto count = double(panels);
    const double columns = stacked ? 1 : count, rows = stacked ? count : 1;
    const double height = areaPt.height() - captionPt(textScale);
    return {
        (areaPt.width() - (columns - 1) * panelGapPt * textScale) / columns -
            (floorsPt + 2 * panelMarginPt) * textScale,
        (height - (rows - 1) * panelGapPt * textScale) / rows - (titlePt + 2 * panelMarginPt) * textScale};
}

bool fitsAt(glm::dvec2 sizeM, double scale, const QSizeF& room) {
    return sizeM.x * pointsPerMetre(scale) <= room.width() &&
           sizeM.y * pointsPerMetre(scale) <= room.height();
}

std::optional<double> scaleFor(glm::dvec2 sizeM, const QSizeF& room) {
    for (const double scale : elevationScales)
        if (fitsAt(sizeM, scale, room)) return scale;
    return std::nullopt;
}

/// Paints one panel.
class PanelPainter {
public:
    PanelPainter(const Canvas& canvas, const QRectF& area, const ElevationDrawing& drawing,
                 const ElevationPanel& panel)
        : canvas_(canvas),
          drawing_(drawing),
          elevation_(*drawing.elevation),
          panel_(panel),
          unit_(drawing.textScale * canvas.point),
          perM_(pointsPerMetre(drawing.layout.scale) * canvas.point) {
        const double width = (elevation_.high.x - elevation_.low.x) * perM_;
        const double height = (elevation_.high.y - elevation_.low.y) * perM_;
        title_ = QRectF(area.left(), area.top(), area.width(), titlePt * unit_);
        const double left = area.left() + (floorsPt + panelMarginPt) * unit_;
        const double room = area.right() - panelMarginPt * unit_ - left;
        picture_ = QRectF(left + std::max(0.0, (room - width) / 2), title_.bottom() + panelMarginPt * unit_,
                          width, height);
    }

    void paint() {
        paintFitted(canvas_, title_, panel_.title, 7.5 * drawing_.textScale, 4, QFont::Medium, ink::quiet,
                    Qt::AlignHCenter);
        if (panel_.cells.empty()) {
            const QRectF words(title_.left(), picture_.top(), title_.width(),
                               std::max(picture_.height(), 12 * unit_));
            return paintFitted(canvas_, words, panel_.note, 7.5 * drawing_.textScale, 3, QFont::Normal,
                               ink::quiet, Qt::AlignHCenter);
        }
        paintWalls();
        paintStoreys();
        for (std::size_t i = 0; i < elevation_.windows.size() && i < panel_.cells.size(); ++i)
            paintGlazing(elevation_.windows[i], panel_.cells[i]);
        canvas_.painter.setPen(linePen(canvas_, ink::text, 1));
        canvas_.painter.drawLine(picture_.bottomLeft(), picture_.bottomRight());
    }

private:
    [[nodiscard]] QPointF at(glm::dvec2 place) const {
        return {picture_.left() + (place.x - elevation_.low.x) * perM_,
                picture_.bottom() - (place.y - elevation_.low.y) * perM_};
    }

    void paintWalls() {
        for (const ElevationFace& face : elevation_.faces) {
            QPainterPath path;
            path.setFillRule(Qt::WindingFill);
            for (const auto& polygon : face.polygons) {
                QPolygonF points;
                for (const glm::dvec2 corner : polygon) points << at(corner);
                QPainterPath piece;
                piece.addPolygon(points);
                piece.closeSubpath();
                path = face.polygons.size() == 1 ? piece : joined(path, piece);
            }
            canvas_.painter.fillPath(path, wallColour);
            canvas_.painter.strokePath(path, linePen(canvas_, wallLine, 0.4));
        }
    }

    /// Few triangles are joined to one outline; of many the outline would take too long.
    static QPainterPath joined(const QPainterPath& path, const QPainterPath& piece) {
        constexpr int maxElements = 400;
        if (path.elementCount() < maxElements) return path.united(piece);
        QPainterPath both = path;
        both.addPath(piece);
        return both;
    }

    /// A thin line at each floor, and its number where there is room for it. The lowest floor is 0.
    void paintStoreys() {
        const double storey = drawing_.storeyM * perM_;
        if (storey < 1.2 * canvas_.point) return;
        const QFont font = textFont(canvas_, 5 * drawing_.textScale);
        const QFontMetricsF metrics(font, canvas_.painter.device());
        const int every = std::max(1, int(std::ceil(minStoreyTextPt * unit_ / storey)));
        for (int floor = 0; floor < 1000; ++floor) {
            const double z = elevation_.floorM + floor * drawing_.storeyM;
            if (z > elevation_.high.y - 0.5) break;
            if (z < elevation_.low.y - 0.01) continue;
            const double y = at({0, z}).y();
            canvas_.painter.setPen(linePen(canvas_, ink::line, 0.3));
            canvas_.painter.drawLine(QPointF(picture_.left() - 2 * unit_, y), QPointF(picture_.right(), y));
            if (floor % every != 0) continue;
            const QString text = QString::number(floor);
            canvas_.painter.setFont(font);
            canvas_.painter.setPen(ink::quiet);
            canvas_.painter.drawText(
                QPointF(picture_.left() - 3 * unit_ - metrics.horizontalAdvance(text), y - 0.8 * unit_),
                text);
        }
    }

    void paintGlazing(const ElevationGlazing& window, const ElevationCell& cell) {
        const QRectF box = QRectF(at({window.low.x, window.high.y}), at({window.high.x, window.low.y}));
        canvas_.painter.setBrush(cell.colour);
        canvas_.painter.setPen(
            linePen(canvas_, ink::quiet, std::min(0.35, 0.06 * box.width() / canvas_.point)));
        canvas_.painter.drawRect(box);
        paintElevationMark(box, cell.mark);
    }

    void paintElevationMark(const QRectF& box, ElevationMark mark);

    Canvas canvas_;
    const ElevationDrawing& drawing_;
    const FacadeElevation& elevation_;
    const ElevationPanel& panel_;
    double unit_, perM_;
    QRectF title_, picture_;
};

/// Crosses and circles have a white line below, so that they are seen on every colour.
void paintMarkIn(const Canvas& canvas, const QRectF& window, ElevationMark mark) {
    const double size = std::min({window.width(), window.height(), 9 * canvas.point}) * 0.62;
    QRectF box(0, 0, size, size);
    box.moveCenter(window.center());
    QPainterPath path;
    if (mark == ElevationMark::fail) {
        path.moveTo(box.topLeft()), path.lineTo(box.bottomRight());
        path.moveTo(box.topRight()), path.lineTo(box.bottomLeft());
    } else if (mark == ElevationMark::borderline) {
        path.addEllipse(box);
    } else {
        const bool isWorse = mark == ElevationMark::worse;
        const double tip = isWorse ? box.bottom() : box.top(), base = isWorse ? box.top() : box.bottom();
        path.moveTo(box.left(), base), path.lineTo(box.right(), base), path.lineTo(box.center().x(), tip);
        path.closeSubpath();
    }
    const QColor colour = mark == ElevationMark::borderline ? QColor(0xe6, 0x9f, 0x00)
                          : mark == ElevationMark::better   ? QColor(0x00, 0x9e, 0x73)
                                                            : QColor(0xb0, 0x2a, 0x1a);
    const double line = size / canvas.point * 0.16;
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(linePen(canvas, ink::paper, line * 2.2));
    canvas.painter.drawPath(path);
    if (mark == ElevationMark::worse || mark == ElevationMark::better) canvas.painter.setBrush(colour);
    canvas.painter.setPen(linePen(canvas, colour, line));
    canvas.painter.drawPath(path);
}

void PanelPainter::paintElevationMark(const QRectF& box, ElevationMark mark) {
    if (mark != ElevationMark::none) paintMarkIn(canvas_, box, mark);
}

void paintMarkLegend(const Canvas& canvas, const QRectF& area, const ElevationFoot& foot) {
    const double unit = foot.textScale * canvas.point;
    const QFont font = textFont(canvas, 7 * foot.textScale);
    const QFontMetricsF metrics(font, canvas.painter.device());
    double x = area.left();
    const auto word = [&](const QString& text) {
        canvas.painter.setFont(font);
        canvas.painter.setPen(ink::text);
        canvas.painter.drawText(QPointF(x, area.top() + 7 * unit), text);
        x += metrics.horizontalAdvance(text) + 10 * unit;
    };
    if (foot.hasMarks)
        for (const auto& [mark, text] : {std::pair{ElevationMark::fail, NM_TEXT("fails")},
                                         std::pair{ElevationMark::borderline, NM_TEXT("borderline")},
                                         std::pair{ElevationMark::worse, NM_TEXT("verdict gets worse")},
                                         std::pair{ElevationMark::better, NM_TEXT("verdict gets better")}}) {
            const QRectF box(x, area.top(), 9 * unit, 9 * unit);
            canvas.painter.setBrush(QColor(0xd8, 0xd9, 0xdc));
            canvas.painter.setPen(linePen(canvas, ink::quiet, 0.35));
            canvas.painter.drawRect(box);
            paintMarkIn(canvas, box, mark);
            x += 12 * unit;
            word(sheetText(text));
        }
    paintFitted(canvas, {x, area.top() - unit, std::max(1.0, area.right() - x), 11 * unit}, foot.note,
                6.6 * foot.textScale, 3.5, QFont::Normal, ink::quiet);
}

}  // namespace

std::optional<ElevationLayout> fitElevation(glm::dvec2 sizeM, std::size_t panels, const QSizeF& areaPt,
                                            double textScale) {
    const auto beside = scaleFor(sizeM, roomOf(areaPt, panels, false, textScale));
    const auto stacked = scaleFor(sizeM, roomOf(areaPt, panels, true, textScale));
    if (!beside && !stacked) return std::nullopt;
    if (beside && (!stacked || *beside <= *stacked)) return ElevationLayout{false, *beside};
    return ElevationLayout{true, *stacked};
}

std::optional<ElevationLayout> fitElevationAt(glm::dvec2 sizeM, std::size_t panels, const QSizeF& areaPt,
                                              double textScale, double scale) {
    for (const bool stacked : {false, true})
        if (fitsAt(sizeM, scale, roomOf(areaPt, panels, stacked, textScale)))
            return ElevationLayout{stacked, scale};
    return std::nullopt;
}

double elevationHeightPt(glm::dvec2 sizeM, std::size_t panels, const ElevationLayout& layout,
                         double textScale) {
    const double panel = (titlePt + 2 * panelMarginPt) * textScale + sizeM.y * pointsPerMetre(layout.scale);
    const double rows = layout.stacked ? double(panels) : 1;
    return captionPt(textScale) + rows * panel + (rows - 1) * panelGapPt * textScale;
}

void paintElevation(const Canvas& canvas, const QRectF& area, const ElevationDrawing& drawing) {
    canvas.painter.save();
    canvas.painter.setRenderHint(QPainter::Antialiasing);
    const double unit = drawing.textScale * canvas.point;
    const double caption = captionPt(drawing.textScale) * canvas.point;
    paintCaption(canvas, {area.left(), area.top(), area.width(), caption}, drawing.caption,
                 drawing.textScale);
    const QRectF room = area.adjusted(0, caption, 0, 0);
    const double count = std::max<double>(1, double(drawing.panels.size())), gap = panelGapPt * unit;
    const bool stacked = drawing.layout.stacked;
    const QSizeF size = stacked ? QSizeF(room.width(), (room.height() - (count - 1) * gap) / count)
                                : QSizeF((room.width() - (count - 1) * gap) / count, room.height());
    QPointF corner = room.topLeft();
    for (const ElevationPanel& panel : drawing.panels) {
        PanelPainter(canvas, {corner, size}, drawing, panel).paint();
        corner += stacked ? QPointF(0, size.height() + gap) : QPointF(size.width() + gap, 0);
    }
    canvas.painter.restore();
}

void paintElevationFoot(const Canvas& canvas, const QRectF& area, const ElevationFoot& foot) {
    canvas.painter.save();
    canvas.painter.setRenderHint(QPainter::Antialiasing);
    const double unit = foot.textScale * canvas.point, gap = 16 * unit;
    const Canvas larger{canvas.painter, unit};
    const double count = std::max<double>(1, double(foot.legends.size()));
    const double width = (area.width() - (count - 1) * gap) / count;
    for (std::size_t i = 0; i < foot.legends.size(); ++i)
        paintLegend(
            larger,
            {area.left() + double(i) * (width + gap), area.top() + 4 * unit, width, legendHeightPt * unit},
            foot.legends[i]);
    paintMarkLegend(canvas, {area.left(), area.top() + 44 * unit, area.width(), 12 * unit}, foot);
    canvas.painter.restore();
}

}  // namespace noonmark
