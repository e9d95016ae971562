#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "app/report/book/diagram.h"
#include "app/report/book/paper.h"
#include "app/report/maps/map_view.h"
#include "app/report/maps/sheet_text.h"

namespace noonmark {

namespace {

struct LegendEntry {
    QString text;
    QColor fill, line;
    double linePt;
    bool isDashed = false;
    bool isLine = false;  ///< else an area
};

void paintSwatch(const Canvas& canvas, const QRectF& box, const LegendEntry& entry) {
    QPen pen = linePen(canvas, entry.line, entry.linePt);
    if (entry.isDashed) pen.setDashPattern({3, 2});
    canvas.painter.setBrush(entry.fill);
    canvas.painter.setPen(pen);
    if (entry.isLine)
        return canvas.painter.drawLine(QLineF(box.left(), box.center().y(), box.right(), box.center().y()));
    canvas.painter.drawRect(box);
}

std::vector<LegendEntry> entriesOf(const DiagramFoot& foot) {
    std::vector<LegendEntry> entries;
    if (foot.subject == DiagramFoot::Subject::fan)
        entries = {{sheetText("shadow of the proposal alone"), shade::incremental.lighter(190),
                    shade::incremental, 0.5}};
    else if (foot.subject == DiagramFoot::Subject::valueLines)
        entries = {{sheetText("hours of shadow"), ink::paper, shade::incremental, 0.9, false, true},
                   {sheetText("limit of the rule"), ink::paper, shade::incremental, 1.8, false, true},
                   {sheetText("distance from the parcel"), ink::paper, ink::text, 0.9, true, true}};
    else
        entries = {{sheetText("existing shadow"), shade::baseline, shade::baseline, 0.2},
                   {sheetText("incremental shadow"), shade::incremental, shade::incremental, 0.2},
                   {sheetText("sun gained"), shade::gained, ink::quiet, 0.3}};
    entries.push_back({sheetText("proposal"), shade::proposal, ink::text, 0.9});
    if (foot.hasRemoved) entries.push_back({sheetText("removed"), ink::paper, ink::text, 0.6, true});
    entries.push_back({sheetText("building"), shade::building, shade::buildingLine, 0.4});
    if (foot.hasOverhangs)
        entries.push_back({sheetText("open below"), ink::paper, shade::buildingLine, 0.5, true});
    if (foot.places.empty()) entries.push_back({sheetText("place"), shade::place, shade::placeLine, 1.1});
    for (const LegendPatch& patch : foot.places)
        entries.push_back({patch.label, shade::place, patch.colour, 1.6});
    return entries;
}

/// In rows from the left; returns nothing beyond `area` as long as the page is at least 300 points wide.
void paintEntries(const Canvas& canvas, const QRectF& area, const DiagramFoot& foot) {
    const double unit = foot.textScale * canvas.point;
    const QFont font = textFont(canvas, 7 * foot.textScale);
    const QFontMetricsF metrics(font, canvas.painter.device());
    double x = area.left(), y = area.top() + 4 * unit;
    for (const LegendEntry& entry : entriesOf(foot)) {
        const double width = 18 * unit + metrics.horizontalAdvance(entry.text);
        if (x > area.left() && x + width > area.right()) x = area.left(), y += 12 * unit;
        paintSwatch(canvas, {x, y, 12 * unit, 7 * unit}, entry);
        canvas.painter.setFont(font);
        canvas.painter.setPen(ink::text);
        canvas.painter.drawText(QPointF(x + 15 * unit, y + 6.4 * unit), entry.text);
        x += width + 8 * unit;
    }
    const bool isImperial = foot.units == UnitSystem::imperial;
    QString words =
        sheetText("Heights in %1 above the ground.").arg(isImperial ? sheetText("ft") : QStringLiteral("m"));
    if (!foot.note.isEmpty()) words = foot.note + QStringLiteral(" ") + words;
    if (foot.hasNumbers) words += sheetText(" Numbers in a white field name the places above.");
    if (foot.hasStreets) words += sheetText(" White lines: streets of the project.");
    if (foot.hasContext) words += sheetText(" Pale colours: streets, water and parks of the map.");
    paintFitted(canvas, {area.left(), y + 10 * unit, area.width(), area.bottom() - y - 10 * unit}, words,
                6.6 * foot.textScale, 4.5, QFont::Normal, ink::quiet);
}

}  // namespace

void paintDiagramFoot(const Canvas& canvas, const QRectF& area, const DiagramFoot& foot) {
    const double unit = foot.textScale * canvas.point;
    const double perMetre = pointsPerMetre(foot.scale) * canvas.point;
    const double arrow = 22 * unit, scaleWidth = 62 * unit;
    const double barRoom = std::min(area.width() * 0.24, 150 * unit);
    const Canvas larger{canvas.painter, unit};
    paintNorthArrow(larger, {area.right() - arrow, area.top() + 2 * unit, arrow, 30 * unit});
    const QRectF bar(area.right() - arrow - barRoom - 4 * unit, area.top() + 6 * unit, barRoom, 30 * unit);
    paintScaleBar(larger, bar, scaleBarWithin((barRoom - 30 * unit) / perMetre, foot.units), perMetre);
    const QRectF scale(bar.left() - scaleWidth, area.top() + 4 * unit, scaleWidth, 14 * unit);
    if (foot.paper.isEmpty())
        return paintEntries(canvas, {area.left(), area.top(), bar.left() - area.left(), area.height()}, foot);
    paintFitted(canvas, scale, QStringLiteral("1:%1").arg(std::llround(foot.scale)), 11 * foot.textScale, 6,
                QFont::Bold);
    paintFitted(canvas, scale.translated(0, 14 * unit), sheetText("on %1").arg(foot.paper),
                7 * foot.textScale, 5, QFont::Normal, ink::quiet);
    paintEntries(canvas, {area.left(), area.top(), scale.left() - area.left() - 6 * unit, area.height()},
                 foot);
}

}  // namespace noonmark
