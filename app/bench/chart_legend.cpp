#include "app/bench/chart_legend.h"

#include <QFontMetricsF>
#include <algorithm>

#include "app/bench/mark_painter.h"

namespace noonmark {

namespace {

constexpr double letterPt = 7;
constexpr double rowPt = 11;
constexpr double keyPt = 16;  // width of the line with its mark
constexpr double gapPt = 10;  // between entries

std::vector<bench::ChartSeries> entriesOf(std::span<const bench::Chart> charts) {
    std::vector<bench::ChartSeries> entries;
    for (const auto& chart : charts)
        for (const auto& series : chart.series)
            if (!series.points.empty() &&
                std::ranges::find(entries, series.name, &bench::ChartSeries::name) == entries.end())
                entries.push_back(series);
    return entries;
}

void paintEntry(const Canvas& canvas, const QPointF& at, const bench::ChartSeries& series,
                const ChartInk& look) {
    const double unit = canvas.point;
    QPen pen = linePen(canvas, look.colour, 1.1);
    if (series.estimated) pen.setDashPattern({4, 2.5});
    canvas.painter.setPen(pen);
    const QPointF middle = at + QPointF(keyPt / 2 - 2, rowPt / 2) * unit;
    const QPointF half(6 * unit, 0);
    if (series.joined) canvas.painter.drawLine(middle - half, middle + half);
    if (series.marked) paintMark(canvas.painter, middle, look, series.estimated, 4.6 * unit, 0.7 * unit);
    canvas.painter.setPen(ink::text);
    const QFontMetricsF metrics(canvas.painter.font());
    canvas.painter.drawText(at + QPointF(keyPt * unit, rowPt * unit / 2 + metrics.ascent() * 0.36),
                            QString::fromStdString(series.name));
}

}  // namespace

double makeLegend(const Canvas& canvas, const QRectF& area, std::span<const bench::Chart> charts,
                  const ChartInks& inks, bool paint) {
    const std::vector<bench::ChartSeries> entries = entriesOf(charts);
    if (entries.size() < 2) return 0;
    canvas.painter.setFont(textFont(canvas, letterPt));
    const QFontMetricsF metrics(canvas.painter.font());
    QPointF at = area.topLeft();
    for (const auto& entry : entries) {
        const double width =
            metrics.horizontalAdvance(QString::fromStdString(entry.name)) + keyPt * canvas.point;
        if (at.x() > area.left() && at.x() + width > area.right())
            at = {area.left(), at.y() + rowPt * canvas.point};
        if (paint) paintEntry(canvas, at, entry, inks.of(entry.colourOf));
        at.rx() += width + gapPt * canvas.point;
    }
    return at.y() + rowPt * canvas.point - area.top();
}

}  // namespace noonmark
