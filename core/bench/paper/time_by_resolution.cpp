#include "core/bench/paper/time_by_resolution.h"

#include <fmt/format.h>

namespace noonmark::bench {

namespace {

void addTo(Finding& finding, int resolution, const StartList& engines, const std::vector<Placing>& placings) {
    for (std::size_t i = 0; i < placings.size(); ++i) {
        const Placing& placing = placings[i];
        TableCell seconds;
        if (placing.timed()) {
            seconds = placing.medianS;
            finding.charts[0].series[i].points.push_back({double(resolution), placing.medianS, {}});
        }
        finding.table.rows.push_back({engines.contestants[i].engine, double(resolution), seconds,
                                      double(placing.runs), placing.error.areaPct, placing.error.cellMeanPct,
                                      placing.refusal});
    }
}

// Four times the cells: from one resolution to its double.
void addGrowth(Finding& finding, int finest) {
    for (const ChartSeries& series : finding.charts[0].series) {
        if (series.points.size() < 2) continue;
        const ChartPoint &first = series.points.front(), &last = series.points.back();
        const double cells = (last.x * last.x) / (first.x * first.x);
        finding.comparisons[0].rows.push_back({series.name, fmt::format("{:.4f}", first.y),
                                               fmt::format("{:.3f}{}", last.y, unlessAt(finest, last.x)),
                                               fmt::format("{:.1f} for {:.0f}", last.y / first.y, cells)});
    }
}

Finding emptyFinding(const BenchSite& site, const Extent& extent, const StartList& engines) {
    Finding finding;
    finding.key = "time_by_resolution";
    finding.title = "Time by resolution";
    finding.text = fmt::format(
        "{:g} m in the middle of the city, divided into increasing numbers of cells, over the hour from noon "
        "on {} at every minute. Medians of {} runs in turn, after the check against rays. The paper found "
        "both accrual maps linear in the number of cells.",
        site.sideM, formatText(site.date), extent.runs);
    finding.table.columns = {"engine",         "cells_a_side",        "time_s", "runs",
                             "area_error_pct", "cell_error_mean_pct", "refusal"};
    finding.comparisons[0].header = {"engine", fmt::format("{}, s", extent.resolutions.front()),
                                     fmt::format("{}, s", extent.resolutions.back()),
                                     "times as long, for cells"};
    finding.charts = {{"Time for one hour of sun", {"cells per side", true}, {"time, s", true}, {}}};
    for (const Contestant& engine : engines.contestants)
        finding.charts[0].series.push_back({.name = engine.name, .colourOf = engine.engine});
    return finding;
}

}  // namespace

Finding benchTimeByResolution(const std::vector<ResolutionRun>& runs, const BenchSite& site,
                              const Extent& extent, const StartList& engines) {
    Finding finding = emptyFinding(site, extent, engines);
    for (const ResolutionRun& run : runs) addTo(finding, run.cellsASide, engines, run.placings);
    addGrowth(finding, extent.resolutions.back());
    return finding;
}

}  // namespace noonmark::bench
