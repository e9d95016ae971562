#include "app/gui/view/panel/view_picture.h"

#include <QFontMetricsF>
#include <QObject>
#include <algorithm>

#include "app/gui/base/looks/units.h"
#include "app/report/maps/map_view.h"
#include "app/report/maps/sheet_text.h"

namespace noonmark {

namespace {

constexpr double pointPx = 1.6;
constexpr double marginPx = 16;
constexpr double legendWidthPx = 560;
constexpr double titlePt = 12;
constexpr double textPt = 7.5;
constexpr double barWidthPx = 190;
constexpr double arrowWidthPx = 30;
constexpr double furniturePx = scaleBarHeightPt * pointPx;
constexpr double scaleNotePx = 14;
constexpr double patchRowPx = 22;
constexpr double footPx = std::max(furniturePx + scaleNotePx, legendHeightPt* pointPx) + marginPx / 2;

struct Line {
    QString text;
    double points;
    QFont::Weight weight;
    QColor colour;
};

QFont fontOf(const Canvas& canvas, const Line& line) { return textFont(canvas, line.points, line.weight); }

// The place of a line's text, wrapped to the width so that nothing is cut.
QRectF placeOf(const Canvas& canvas, const Line& line, double top, double width) {
    if (line.text.isEmpty()) return {marginPx, top, width, 0};
    const QRectF room(marginPx, top, width, 1e4);
    const QRectF needed =
        QFontMetricsF(fontOf(canvas, line)).boundingRect(room, Qt::TextWordWrap | Qt::AlignLeft, line.text);
    return {marginPx, top, width, needed.height() + 3};
}

// Paints the lines, or only measures them without `paint`. Returns the y below them.
double takeLines(const Canvas& canvas, const std::vector<Line>& lines, double top, double width, bool paint) {
    for (const Line& line : lines) {
        const QRectF place = placeOf(canvas, line, top, width);
        if (paint && !line.text.isEmpty()) {
            canvas.painter.setFont(fontOf(canvas, line));
            canvas.painter.setPen(line.colour);
            canvas.painter.drawText(place, Qt::TextWordWrap | Qt::AlignLeft, line.text);
        }
        top = place.bottom();
    }
    return top;
}

void paintTurnedNorth(const Canvas& canvas, const QRectF& area, double headingDeg) {
    canvas.painter.save();
    canvas.painter.translate(area.center());
    canvas.painter.rotate(-headingDeg);
    paintNorthArrow(canvas, area.translated(-area.center()));
    canvas.painter.restore();
}

// North arrow and scale bar at the right. In a slanted view the scale is valid in the middle only, and a
// label states this.
void paintFurniture(const Canvas& canvas, const QRectF& foot, const PictureFrame& frame) {
    const QRectF arrow(foot.right() - arrowWidthPx, foot.top(), arrowWidthPx, furniturePx);
    paintTurnedNorth(canvas, arrow, frame.headingDeg);
    const QRectF bar(arrow.left() - barWidthPx - 10, foot.top(), barWidthPx, furniturePx);
    const double longestM = (barWidthPx - 40) / frame.pixelsPerM;
    if (!(longestM > 0)) return;
    paintScaleBar(canvas, bar, scaleBarWithin(longestM, unitsInUse()), frame.pixelsPerM);
    if (frame.fromAbove) return;
    canvas.painter.setFont(textFont(canvas, 6.5));
    canvas.painter.setPen(ink::quiet);
    canvas.painter.drawText(QRectF(bar.left(), bar.bottom() - 12, bar.width(), scaleNotePx), Qt::AlignRight,
                            QObject::tr("in the middle of the picture"));
}

// One row of patches with their labels; what the width has no room for is left out.
void paintPatches(const Canvas& canvas, const QRectF& row, const std::vector<LegendPatch>& patches) {
    constexpr double side = 9, gap = 5;
    canvas.painter.setFont(textFont(canvas, textPt));
    double left = row.left();
    for (const LegendPatch& patch : patches) {
        const double wide = QFontMetricsF(canvas.painter.font()).horizontalAdvance(patch.label);
        if (left + side + gap + wide > row.right()) return;
        canvas.painter.fillRect(QRectF(left, row.center().y() - side / 2, side, side), patch.colour);
        left += side + gap;
        canvas.painter.setPen(ink::text);
        canvas.painter.drawText(QRectF(left, row.top(), wide + 1, row.height()), Qt::AlignVCenter,
                                patch.label);
        left += wide + 3 * gap;
    }
}

/// Where the parts of a picture lie, in pixels of a scale of 1.
struct Layout {
    double width, head, patches, words;
    std::vector<Line> above, below;

    Layout(double pictureWidth, const PictureFrame& frame)
        : width(pictureWidth - 2 * marginPx),
          above{{frame.title, titlePt, QFont::Bold, ink::text},
                {frame.when, textPt + 1, QFont::Normal, ink::quiet}},
          below{{frame.note, textPt, QFont::Normal, ink::text},
                {frame.credit, textPt, QFont::Normal, ink::quiet}} {
        QImage measure(1, 1, QImage::Format_RGB32);
        QPainter measuring(&measure);
        head = takeLines({measuring, pointPx}, above, marginPx, width, false) + marginPx / 2;
        patches = frame.buildings.empty() ? 0 : patchRowPx;
        words = takeLines({measuring, pointPx}, below, 0, width, false);
    }
    [[nodiscard]] double belowView() const { return marginPx + footPx + patches + words + marginPx; }
};

}  // namespace

int heightOfFrame(int width, const PictureFrame& frame, double scale) {
    const Layout layout(width / scale, frame);
    return int(layout.head * scale) + int(layout.belowView() * scale);
}

QImage viewPicture(const QImage& view, const PictureFrame& frame, double scale) {
    const Layout layout(view.width() / scale, frame);
    const int top = int(layout.head * scale);
    QImage picture(view.width(), top + view.height() + int(layout.belowView() * scale), QImage::Format_RGB32);
    picture.fill(ink::paper);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawImage(QPoint(0, top), view);
    painter.scale(scale, scale);
    const Canvas canvas{painter, pointPx};
    const SheetScope words;
    takeLines(canvas, layout.above, marginPx, layout.width, true);
    const QRectF foot(marginPx, (top + view.height()) / scale + marginPx, layout.width, footPx);
    const double legendWidth =
        std::min(legendWidthPx, layout.width - barWidthPx - arrowWidthPx - 3 * marginPx);
    PictureFrame scaled = frame;
    scaled.pixelsPerM /= scale;
    if (frame.legend && legendWidth > 0)
        paintLegend(canvas, {foot.left(), foot.top(), legendWidth, foot.height()}, *frame.legend);
    paintFurniture(canvas, foot, scaled);
    paintPatches(canvas, {marginPx, foot.bottom(), layout.width, layout.patches}, frame.buildings);
    takeLines(canvas, layout.below, foot.bottom() + layout.patches, layout.width, true);
    return picture;
}

}  // namespace noonmark
