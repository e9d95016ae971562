#include "app/bench/bench_pages.h"

#include <fmt/format.h>
#include <QBuffer>
#include <QFontMetricsF>
#include <QIODevice>
#include <QPdfWriter>
#include <QRectF>
#include <algorithm>

#include "app/bench/chart_painter.h"
#include "app/report/files/output_folder.h"
#include "app/report/maps/style.h"
#include "app/report/sheets/pdf_page.h"
#include "app/report/sheets/sheet.h"
#include "app/report/sheets/study_text.h"
#include "app/report/sheets/text_column.h"
#include "core/lab/bench/finding.h"

namespace noonmark {

namespace {

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
constexpr double blockGapPt = 7;    // between the parts of a block
constexpr double gutterPt = 16;     // between columns
constexpr double chartShare = 0.6;  // share of the width where tables stand beside the chart
constexpr std::size_t maxRemarks = 4;

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
    return height > 0 ? height + blockGapPt * canvas_.point : 0;
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
    const double gap = blockGapPt * canvas_.point;
    const double legend = legendsHeight();
    if (oneChart()) return heightOf(canvas_, title(), width_, textPt) + 2 * gap + legend;
    return heightOf(canvas_, title(), width_, textPt) + heightOf(canvas_, words(), width_, textPt) + legend +
           (chartRows() + 2) * gap + tablesHeight();
}

double FindingBlock::paint(const QPointF& top, double chartHeight) const {
    const double height = heightOf(canvas_, title(), width_, textPt), gap = blockGapPt * canvas_.point;
    paintBlocks(canvas_, title(), {top, QSizeF(width_, height)}, textPt);
    const QPointF below = top + QPointF(0, height);
    return oneChart() ? paintBeside(below + QPointF(0, gap), chartHeight)
                      : paintStacked(below + QPointF(0, 0.4 * gap), chartHeight);
}

double FindingBlock::paintBeside(const QPointF& top, double chartHeight) const {
    const double gutter = gutterPt * canvas_.point, gap = blockGapPt * canvas_.point;
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
    const double gap = blockGapPt * canvas_.point, across = columnWidth() + gutterPt * canvas_.point;
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

constexpr double bottomPt = 40;
constexpr double summaryPt = 7.8;
constexpr double extentPt = 7;
constexpr double gapPt = 18;  // between the blocks of a page
constexpr double maxChartPt = 330;

/// The pages of one report.
class BenchPages {
public:
    BenchPages(QPdfWriter& writer, QPainter& painter, const bench::BenchReport& report)
        : writer_(writer), canvas_(pdfCanvas(painter)), report_(report), inks_(report.findings) {}

    void paint() {
        paintFirst();
        for (std::size_t i = 1; i < report_.findings.size(); i += 2) {
            writer_.newPage();
            paintBlocks(i, std::min(i + 2, report_.findings.size()), topPt);
            paintFoot();
        }
    }

private:
    [[nodiscard]] QRectF area(double x, double y, double width, double height) const {
        return {x * canvas_.point, y * canvas_.point, width * canvas_.point, height * canvas_.point};
    }

    void paintFirst() {
        paintHeadline(canvas_, area(sidePt, topPt, contentPt, headlineHeightPt), headline());
        const bench::Comparison summary = summaryTable(report_);
        const double top = topPt + headlineHeightPt + 4;
        paintComparison(canvas_, area(sidePt, top, contentPt, 0), summary, summaryPt);
        const double below = top + heightOf(canvas_, summary, summaryPt) / canvas_.point + 4;
        const TextBlocks extent{body(QString::fromStdString(report_.extent))};
        const double end =
            noonmark::paintBlocks(canvas_, extent, area(sidePt, below, contentPt, 100), extentPt);
        if (!report_.findings.empty()) paintBlocks(0, 1, end / canvas_.point + gapPt);
        paintFoot();
    }

    [[nodiscard]] Headline headline() const {
        return {QString::fromStdString(report_.title), QString::fromStdString(report_.site),
                QString::fromStdString(
                    fmt::format("{}; measured in {:.0f} s", report_.machine, report_.seconds))};
    }

    /// Findings [first, last) below `topPoints`; their charts share the remaining height.
    void paintBlocks(std::size_t first, std::size_t last, double topPoints) {
        std::vector<FindingBlock> blocks;
        double fixed = double(last - first - 1) * gapPt * canvas_.point;
        int rows = 0;
        for (std::size_t i = first; i < last; ++i) {
            blocks.emplace_back(canvas_, report_.findings[i], inks_, contentPt * canvas_.point);
            fixed += blocks.back().heightWithoutCharts();
            rows += blocks.back().chartRows();
        }
        const double room = (pageHeightPt - bottomPt - topPoints) * canvas_.point - fixed;
        const double chart = std::min(maxChartPt * canvas_.point, room / std::max(1, rows));
        double y = topPoints * canvas_.point;
        for (const FindingBlock& block : blocks)
            y = block.paint({sidePt * canvas_.point, y}, chart) + gapPt * canvas_.point;
    }

    void paintFoot() {
        const QRectF foot = area(sidePt, pageHeightPt - bottomPt + 14, contentPt, 10);
        canvas_.painter.setFont(textFont(canvas_, 7));
        canvas_.painter.setPen(ink::quiet);
        canvas_.painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter,
                                 QString::fromStdString(report_.site + "; " + report_.machine));
        canvas_.painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter,
                                 QStringLiteral("%1, page %2").arg(describeProgram()).arg(++page_));
    }

    QPdfWriter& writer_;
    Canvas canvas_;
    const bench::BenchReport& report_;
    ChartInks inks_;
    int page_ = 0;
};

/// Writes the report of a benchmark as a PDF of A4 pages: the summary with the first finding, then two
/// findings per page. Every page names city, date and machine. Text remains text, charts are vectors.
/// `device` must be open. False if the PDF could not be started or completed. Needs a QApplication.
bool writeBenchPages(const bench::BenchReport& report, QIODevice& device) {
    QPdfWriter writer(&device);
    beginPdf(writer, QString::fromStdString(report.title));
    QPainter painter;
    if (!painter.begin(&writer)) return false;
    BenchPages(writer, painter, report).paint();
    return painter.end();
}

}  // namespace

Result<std::vector<std::filesystem::path>> writeBenchFiles(const bench::BenchReport& report,
                                                           const std::filesystem::path& folder,
                                                           const OutputRules& rules) {
    OutputFolder files(folder, rules);
    for (const bench::Finding& finding : report.findings)
        if (!finding.key.empty()) files.add(finding.key + ".csv", textContent(toCsv(finding.table)));
    QBuffer pages;  // charts are painted on this thread only
    pages.open(QIODevice::WriteOnly);
    const bool painted = writeBenchPages(report, pages);
    files.add("report.pdf",
              [&](QIODevice& device) { return painted && device.write(pages.data()) == pages.size(); });
    files.add("summary.json", textContent(summaryJson(report)));
    return std::move(files).result();
}

std::vector<std::string> benchFileNames(std::span<const char* const> keys) {
    std::vector<std::string> names{"report.pdf", "summary.json"};
    for (const char* key : keys) names.push_back(std::string(key) + ".csv");
    return names;
}

}  // namespace noonmark
