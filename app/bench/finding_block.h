#pragma once

#include <QRectF>

#include "app/bench/comparison_painter.h"
#include "app/report/maps/style.h"
#include "app/report/sheets/text_column.h"
#include "core/bench/finding.h"

namespace noonmark {

/// One finding on a page: title, text, charts with their legend, tables. A single chart has text and tables
/// beside it; two charts stand side by side between text and tables; more charts stand in two columns.
class FindingBlock {
public:
    FindingBlock(const Canvas& canvas, const bench::Finding& finding, const ChartInks& inks, double width);

    /// Height of everything but the charts, painter units.
    [[nodiscard]] double heightWithoutCharts() const;
    /// Number of rows of charts; 0 without charts.
    [[nodiscard]] int chartRows() const;
    /// Paints the block from `top`; each row of charts is `chartHeight` high. Returns the y below the block.
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
