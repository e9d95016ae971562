#include "core/bench/bench_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/bench/contests/moments.h"

namespace noonmark::bench {

void fillSummary(BenchReport& report) {
    for (SummaryFigure& figure : report.summary)
        for (const Finding& finding : report.findings)
            if (const auto found = finding.summary.find(figure.key); found != finding.summary.end())
                figure.value = found->second;
}

namespace {

bool misses(const SummaryFigure& figure) {
    constexpr double allowance = 1.25;
    if (!figure.target) return false;
    if (!figure.value) return true;
    const double wanted = figure.target->value;
    return figure.target->isLeast ? *figure.value * allowance < wanted : *figure.value > wanted * allowance;
}

}  // namespace

SummaryFigure targetFigure(std::string key, std::string what, Target target) {
    return {std::move(key),
            std::move(what),
            fmt::format("{} {:g}", target.isLeast ? ">=" : "<=", target.value),
            {},
            target};
}

std::vector<SummaryFigure> listMissed(const BenchReport& report) {
    std::vector<SummaryFigure> missed;
    std::ranges::copy_if(report.summary, std::back_inserter(missed), misses);
    return missed;
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
