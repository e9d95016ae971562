#include "core/bench/paper/memory_by_resolution.h"

#include <fmt/format.h>

#include <map>

namespace noonmark::bench {

namespace {

constexpr double mebibyte = 1024 * 1024;

/// Table 2: MB at 2048 x 2048, and bytes per cell.
struct PaperMemory {
    const char* name;
    double mebibytesAt2048;
};
const std::map<std::string, PaperMemory, std::less<>>& paperTable() {
    static const std::map<std::string, PaperMemory, std::less<>> table{{"shadow-map-gl", {"Shadow map", 16}},
                                                                       {"sam", {"Shadow accrual map", 960}},
                                                                       {"ray", {"Ray tracing", 16}},
                                                                       {"iam", {"Inverse accrual map", 224}}};
    return table;
}

void addTo(Finding& finding, std::size_t place, const Contestant& engine, int resolution,
           const std::optional<std::uint64_t>& bytes) {
    if (!bytes) return;
    finding.table.rows.push_back({engine.engine, double(resolution), double(*bytes) / mebibyte});
    finding.charts[0].series[place].points.push_back({double(resolution), double(*bytes) / mebibyte, {}});
}

std::string paperBytesACell(const std::string& engine) {
    const auto paper = paperTable().find(engine);
    if (paper == paperTable().end()) return {};
    return fmt::format("{:.0f}", paper->second.mebibytesAt2048 * mebibyte / (2048.0 * 2048.0));
}

// Bytes per cell between the smallest and the largest resolution, so that constant memory cancels.
void addComparison(Finding& finding, int finest) {
    for (const ChartSeries& series : finding.charts[0].series) {
        if (series.points.size() < 2) continue;
        const ChartPoint &first = series.points.front(), &last = series.points.back();
        const double bytes = mebibyte * (last.y - first.y) / (last.x * last.x - first.x * first.x);
        finding.comparisons[0].rows.push_back(
            {series.name, fmt::format("{:.0f}{}", last.y, unlessAt(finest, last.x)),
             fmt::format("{:.0f}", bytes), paperBytesACell(series.colourOf)});
    }
}

void addPaper(Finding& finding, const Extent& extent) {
    for (const auto& [key, paper] : paperTable()) {
        ChartSeries series{
            .name = std::string(paper.name) + ", paper", .colourOf = key, .marked = false, .estimated = true};
        for (const int resolution : {extent.resolutions.front(), extent.resolutions.back()})
            series.points.push_back({double(resolution),
                                     paper.mebibytesAt2048 * resolution * resolution / (2048.0 * 2048.0),
                                     {}});
        finding.charts[0].series.push_back(std::move(series));
    }
}

Finding emptyFinding(const StartList& engines, const Extent& extent) {
    Finding finding;
    finding.key = "memory_by_resolution";
    finding.title = "Memory by resolution";
    finding.text =
        "Peak memory of the process while an engine computed the hour of the previous page, beyond city and "
        "receivers: includes the field, and the ray scene of the buildings in reach if there is one. Bytes "
        "per cell are computed between the smallest and the largest resolution, so that constant memory "
        "cancels. The paper counts the maps only.";
    finding.table.columns = {"engine", "cells_a_side", "peak_mib"};
    finding.comparisons[0].header = {"engine", fmt::format("MiB at {}", extent.resolutions.back()),
                                     "bytes per cell", "paper"};
    finding.charts = {{"Memory of an engine", {"cells per side", true}, {"peak, MiB", true}, {}}};
    for (const Contestant& engine : engines.contestants)
        finding.charts[0].series.push_back({.name = engine.name, .colourOf = engine.engine});
    return finding;
}

}  // namespace

Finding benchMemoryByResolution(const std::vector<ResolutionRun>& runs, const Extent& extent,
                                const StartList& engines) {
    Finding finding = emptyFinding(engines, extent);
    for (const ResolutionRun& run : runs)
        for (std::size_t i = 0; i < run.placings.size(); ++i)
            if (const Placing& placing = run.placings[i]; placing.timed())
                addTo(finding, i, engines.contestants[i], run.cellsASide, placing.peakBytes);
    addComparison(finding, extent.resolutions.back());
    addPaper(finding, extent);
    return finding;
}

}  // namespace noonmark::bench
