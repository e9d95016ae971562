#include "app/bench/chart_painter.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>

namespace noonmark {

namespace {

constexpr std::array<ChartInk, 10> engineInks{{{{0x1d, 0x20, 0x27}, MarkShape::circle},
                                               {{0x00, 0x72, 0xb2}, MarkShape::square},
                                               {{0xd5, 0x5e, 0x00}, MarkShape::triangle},
                                               {{0x00, 0x9e, 0x73}, MarkShape::diamond},
                                               {{0xcc, 0x79, 0xa7}, MarkShape::pentagon},
                                               {{0xe6, 0x9f, 0x00}, MarkShape::circle},
                                               {{0x56, 0xb4, 0xe9}, MarkShape::square},
                                               {{0x88, 0x22, 0x55}, MarkShape::triangle},
                                               {{0x99, 0x99, 0x33}, MarkShape::diamond},
                                               {{0x6b, 0x6f, 0x76}, MarkShape::pentagon}}};

}  // namespace

ChartInks::ChartInks(const std::vector<bench::Finding>& findings) {
    inks_ = {{"", {ink::quiet, MarkShape::circle}},
             {"ours", {{0x00, 0x72, 0xb2}, MarkShape::circle}},
             {"edge", {{0x56, 0xb4, 0xe9}, MarkShape::square}},
             {"most", {{0xd5, 0x5e, 0x00}, MarkShape::triangle}},
             {"paper", {{0xe6, 0x9f, 0x00}, MarkShape::diamond}}};
    std::size_t next = 0;
    for (const auto& finding : findings)
        for (const auto& chart : finding.charts)
            for (const auto& series : chart.series)
                if (inks_.try_emplace(series.colourOf, engineInks[next % engineInks.size()]).second) ++next;
}

ChartInk ChartInks::of(const std::string& word) const {
    const auto found = inks_.find(word);
    return found == inks_.end() ? ChartInk{ink::quiet} : found->second;
}

namespace {

constexpr double rowHeight = 1.62;  // times the font size
constexpr double columnGap = 1.1;
constexpr double maxSpare = 3;

using Row = std::vector<std::string>;

QString formatText(const Row& row, std::size_t column) {
    return column < row.size() ? QString::fromStdString(row[column]) : QString();
}

double widthOf(const bench::Comparison& comparison, std::size_t column, const QFontMetricsF& bold,
               const QFontMetricsF& plain) {
    double width = bold.horizontalAdvance(formatText(comparison.header, column));
    for (const Row& row : comparison.rows)
        width = std::max(width, plain.horizontalAdvance(formatText(row, column)));
    return width;
}

// Spare width is shared equally among the columns, up to a limit that keeps rows readable; missing width is
// taken from the first column.
std::vector<double> columnWidths(const Canvas& canvas, const bench::Comparison& comparison, double width,
                                 double points) {
    const QFontMetricsF bold(textFont(canvas, points, QFont::Bold)), plain(textFont(canvas, points));
    std::vector<double> widths;
    double spare = width;
    for (std::size_t column = 0; column < comparison.header.size(); ++column) {
        const double gap = column > 0 ? columnGap * points * canvas.point : 0;
        widths.push_back(widthOf(comparison, column, bold, plain) + gap);
        spare -= widths.back();
    }
    if (widths.empty()) return widths;
    const double share = std::min(spare / double(widths.size()), maxSpare * points * canvas.point);
    if (share < 0)
        widths[0] = std::max(0.0, widths[0] + spare);
    else
        for (double& one : widths) one += share;
    return widths;
}

void paintRow(const Canvas& canvas, QRectF cell, const Row& row, const std::vector<double>& widths) {
    const QFontMetricsF metrics(canvas.painter.font());
    const QPointF left = cell.bottomLeft();
    for (std::size_t column = 0; column < widths.size(); ++column) {
        cell.setWidth(widths[column]);
        const QString text = metrics.elidedText(formatText(row, column), Qt::ElideRight, cell.width());
        canvas.painter.setPen(ink::text);
        canvas.painter.drawText(cell, (column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter,
                                text);
        cell.translate(widths[column], 0);
    }
    canvas.painter.setPen(linePen(canvas, ink::line, 0.4));
    canvas.painter.drawLine(left, QPointF(cell.left(), left.y()));
}

}  // namespace

double heightOf(const Canvas& canvas, const bench::Comparison& comparison, double points) {
    const double rows = comparison.rows.empty() ? 0 : double(comparison.rows.size()) + 1;
    return rows * rowHeight * points * canvas.point;
}

void paintComparison(const Canvas& canvas, const QRectF& area, const bench::Comparison& comparison,
                     double points) {
    if (comparison.rows.empty()) return;
    const auto widths = columnWidths(canvas, comparison, area.width(), points);
    QRectF row(area.left(), area.top(), area.width(), rowHeight * points * canvas.point);
    canvas.painter.setFont(textFont(canvas, points, QFont::Bold));
    paintRow(canvas, row, comparison.header, widths);
    canvas.painter.setFont(textFont(canvas, points));
    for (const Row& cells : comparison.rows) {
        row.translate(0, row.height());
        paintRow(canvas, row, cells, widths);
    }
}

}  // namespace noonmark
