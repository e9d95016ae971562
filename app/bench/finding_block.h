#pragma once

#include <QRectF>

#include "app/bench/chart_inks.h"
#include "app/report/sheets/style.h"
#include "app/report/sheets/text_column.h"
#include "core/bench/finding.h"

namespace noonmark {

/// One finding on a page: title, words, charts with their legend, tables. A single chart has words and tables
/// at its side; two stand side by side between them, more in two columns.
class FindingBlock {
public:
    FindingBlock(const Canvas& canvas, const bench::Finding& finding, const ChartInks& inks, double width);

    /// What it needs without its charts, painter units.
    [[nodiscard]] double heightWithoutCharts() const;
    /// Rows of charts, 0 where it has none.
    [[nodiscard]] int chartRows() const;
    /// From `top` on, each row of charts so high. Returns the y below.
    double paint(const QPointF& top, double chartHeight) const;

private:
    [[nodiscard]] TextBlocks title() const;
    [[nodiscard]] TextBlocks words() const;
    [[nodiscard]] bool oneChart() const;
    [[nodiscard]] double tablesHeight() const;
    [[nodiscard]] double legendsHeight() const;
    [[nodiscard]] double columnWidth() const;
    double paintBeside(const QPointF& top, double chartHeight) const;
    double paintStacked(const QPointF& top, double chartHeight) const;
    void paintTables(const QRectF& area) const;

    Canvas canvas_;
    const bench::Finding& finding_;
    const ChartInks& inks_;
    double width_;
};

}  // namespace noonmark
