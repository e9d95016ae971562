#include "app/bench/finding_block.h"

#include <QFontMetricsF>
#include <algorithm>
#include <span>

#include "app/bench/chart_painter.h"

namespace noonmark {

namespace {

constexpr double letterPt = 7;
constexpr double rowPt = 11;
constexpr double keyPt = 16;       // width of the line with its mark
constexpr double entryGapPt = 10;  // between entries

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

/// Lays out the names of the charts' series, each once, with their marks and lines, in rows from the top of
/// `area`. Paints them if `paint`. Returns the height in painter units; 0 where there is only one name.
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
        at.rx() += width + entryGapPt * canvas.point;
    }
    return at.y() + rowPt * canvas.point - area.top();
}

constexpr double textPt = 7.8;
constexpr double tablePt = 7;
constexpr double gapPt = 7;         // between the parts of a block
constexpr double gutterPt = 16;     // between columns
constexpr double chartShare = 0.6;  // share of the width where tables stand beside the chart
constexpr std::size_t maxRemarks = 4;

}  // namespace

FindingBlock::FindingBlock(const Canvas& canvas, const bench::Finding& finding, const ChartInks& inks,
                           double width)
    : canvas_(canvas), finding_(finding), inks_(inks), width_(width) {}

TextBlocks FindingBlock::title() const { return {heading(QString::fromStdString(finding_.title))}; }

TextBlocks FindingBlock::words() const {
    TextBlocks blocks{body(QString::fromStdString(finding_.text))};
    for (std::size_t i = 0; i < std::min(finding_.remarks.size(), maxRemarks); ++i)
        blocks.push_back(body(QStringLiteral("Left out: ") + QString::fromStdString(finding_.remarks[i])));
    if (finding_.remarks.size() > maxRemarks)
        blocks.push_back(body(
            QStringLiteral("Left out: %1 more, see the tables").arg(finding_.remarks.size() - maxRemarks)));
    return blocks;
}

bool FindingBlock::oneChart() const { return finding_.charts.size() == 1; }

int FindingBlock::chartRows() const { return int(finding_.charts.size() + 1) / 2; }

double FindingBlock::tablesHeight() const {
    double height = 0;
    for (const auto& comparison : finding_.comparisons)
        height = std::max(height, heightOf(canvas_, comparison, tablePt));
    return height > 0 ? height + gapPt * canvas_.point : 0;
}

// Two charts have one legend each; other numbers of charts share one.
double FindingBlock::legendsHeight() const {
    const std::span<const bench::Chart> charts = finding_.charts;
    if (charts.size() != 2) return makeLegend(canvas_, {0, 0, width_, 0}, charts, inks_, false);
    const QRectF half(0, 0, columnWidth(), 0);
    return std::max(makeLegend(canvas_, half, charts.first(1), inks_, false),
                    makeLegend(canvas_, half, charts.last(1), inks_, false));
}

double FindingBlock::columnWidth() const { return (width_ - gutterPt * canvas_.point) / 2; }

double FindingBlock::heightWithoutCharts() const {
    const double gap = gapPt * canvas_.point;
    const double legend = legendsHeight();
    if (oneChart()) return heightOf(canvas_, title(), width_, textPt) + 2 * gap + legend;
    return heightOf(canvas_, title(), width_, textPt) + heightOf(canvas_, words(), width_, textPt) + legend +
           (chartRows() + 2) * gap + tablesHeight();
}

double FindingBlock::paint(const QPointF& top, double chartHeight) const {
    const double height = heightOf(canvas_, title(), width_, textPt), gap = gapPt * canvas_.point;
    paintBlocks(canvas_, title(), {top, QSizeF(width_, height)}, textPt);
    const QPointF below = top + QPointF(0, height);
    return oneChart() ? paintBeside(below + QPointF(0, gap), chartHeight)
                      : paintStacked(below + QPointF(0, 0.4 * gap), chartHeight);
}

double FindingBlock::paintBeside(const QPointF& top, double chartHeight) const {
    const double gutter = gutterPt * canvas_.point, gap = gapPt * canvas_.point;
    const QRectF chart(top, QSizeF(width_ * chartShare, chartHeight));
    paintChart(canvas_, chart, finding_.charts[0], inks_);
    QRectF side(chart.right() + gutter, chart.top(), width_ - chart.width() - gutter, chartHeight);
    side.setTop(paintBlocks(canvas_, words(), side, textPt) + gap);
    for (const auto& comparison : finding_.comparisons) {
        paintComparison(canvas_, side, comparison, tablePt);
        side.translate(0, heightOf(canvas_, comparison, tablePt) + gap);
    }
    const QRectF legend(top.x(), chart.bottom() + gap, width_, 0);
    return legend.top() + makeLegend(canvas_, legend, finding_.charts, inks_, true);
}

double FindingBlock::paintStacked(const QPointF& top, double chartHeight) const {
    const double gap = gapPt * canvas_.point, across = columnWidth() + gutterPt * canvas_.point;
    QRectF area(top, QSizeF(width_, heightOf(canvas_, words(), width_, textPt)));
    area.moveTop(paintBlocks(canvas_, words(), area, textPt) + gap);
    const std::span<const bench::Chart> charts = finding_.charts;
    for (std::size_t i = 0; i < charts.size(); ++i) {
        const std::size_t column = i % 2, row = i / 2;
        const QPointF corner =
            area.topLeft() + QPointF(double(column) * across, double(row) * (chartHeight + gap));
        paintChart(canvas_, {corner, QSizeF(columnWidth(), chartHeight)}, charts[i], inks_);
        const QRectF below(corner.x(), corner.y() + chartHeight + gap, columnWidth(), 0);
        if (charts.size() == 2) makeLegend(canvas_, below, charts.subspan(i, 1), inks_, true);
    }
    area.translate(0, chartRows() * (chartHeight + gap));
    if (charts.size() > 2) makeLegend(canvas_, area, charts, inks_, true);
    area.translate(0, legendsHeight());
    paintTables({area.left(), area.top() + gap, width_, 0});
    return area.top() + tablesHeight();
}

void FindingBlock::paintTables(const QRectF& area) const {
    const double count = double(std::max<std::size_t>(1, finding_.comparisons.size()));
    const double gutter = gutterPt * canvas_.point, width = (area.width() - (count - 1) * gutter) / count;
    QRectF place(area.left(), area.top(), width, area.height());
    for (const auto& comparison : finding_.comparisons) {
        paintComparison(canvas_, place, comparison, tablePt);
        place.translate(width + gutter, 0);
    }
}

}  // namespace noonmark
