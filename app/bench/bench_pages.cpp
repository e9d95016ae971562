#include "app/bench/bench_pages.h"

#include <fmt/format.h>
#include <QBuffer>
#include <QIODevice>
#include <QPdfWriter>
#include <algorithm>

#include "app/bench/comparison_painter.h"
#include "app/bench/finding_block.h"
#include "app/report/files/output_folder.h"
#include "app/report/sheets/pdf_page.h"
#include "app/report/sheets/sheet.h"
#include "app/report/sheets/study_words.h"

namespace noonmark {

namespace {

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
