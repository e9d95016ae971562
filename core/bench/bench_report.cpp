#include "core/bench/bench_report.h"

#include <nlohmann/json.hpp>

#include "core/bench/contests/moments.h"

namespace noonmark::bench {

void fillSummary(BenchReport& report) {
    for (SummaryFigure& figure : report.summary)
        for (const Finding& finding : report.findings)
            if (const auto found = finding.summary.find(figure.key); found != finding.summary.end())
                figure.value = found->second;
}

std::string summaryJson(const BenchReport& report) {
    nlohmann::ordered_json json;
    for (const SummaryFigure& figure : report.summary)
        json[figure.key] = figure.value ? nlohmann::ordered_json(*figure.value) : nlohmann::ordered_json();
    return json.dump(2) + '\n';
}

Comparison summaryTable(const BenchReport& report) {
    Comparison table{{"", "ours", report.reference}, {}};
    for (const SummaryFigure& figure : report.summary)
        table.rows.push_back(
            {figure.what, figure.value ? formatThreeDigits(*figure.value) : "not measured", figure.paper});
    return table;
}

}  // namespace noonmark::bench
