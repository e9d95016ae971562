#include "core/bench/time_by_resolution.h"

#include <fmt/format.h>

#include "core/bench/contest.h"

namespace noonmark::bench {

namespace {

Result<std::vector<Placing>> placingsAt(int resolution, const BenchSite& site, const Extent& extent,
                                        const StartList& engines, const Work& work) {
    const auto receivers = receiversAt(site, resolution, work.stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    const auto sun = noonHour(site);
    if (!sun) return tl::make_unexpected(sun.error());
    const Scene scene{site.city, *receivers, *sun};
    const auto truth = truthOf(scene, *receivers, work);
    if (!truth) return tl::make_unexpected(truth.error());
    return contest(scene, engines.contestants, *truth, extent, work);
}

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

// Four times the cells from one resolution to its double.
void addGrowth(Finding& finding) {
    for (const ChartSeries& series : finding.charts[0].series) {
        if (series.points.size() < 2) continue;
        const ChartPoint &first = series.points.front(), &last = series.points.back();
        const double cells = (last.x * last.x) / (first.x * first.x);
        finding.comparisons[0].rows.push_back({series.name, fmt::format("{:.4f}", first.y),
                                               fmt::format("{:.3f}", last.y),
                                               fmt::format("{:.1f} for {:.0f}", last.y / first.y, cells)});
    }
}

Finding emptyFinding(const BenchSite& site, const Extent& extent, const StartList& engines) {
    Finding finding;
    finding.key = "time_by_resolution";
    finding.title = "Time by resolution";
    finding.text = fmt::format(
        "{:g} m in the middle of the city cut into more and more cells, the hour from noon on {} at every "
        "minute. Medians of {} runs in turn, after the check against rays. The paper found both accrual maps "
        "linear in the number of cells.",
        site.sideM, textOf(site.date), extent.runs);
    finding.table.columns = {"engine",         "cells_a_side",        "time_s", "runs",
                             "area_error_pct", "cell_error_mean_pct", "refusal"};
    finding.comparisons[0].header = {"engine", fmt::format("{}, s", extent.resolutions.front()),
                                     fmt::format("{}, s", extent.resolutions.back()), "times, for cells"};
    finding.charts = {{"Time for one hour of sun", {"cells a side", true}, {"time, s", true}, {}}};
    for (const Contestant& engine : engines.contestants)
        finding.charts[0].series.push_back({.name = engine.name, .colourOf = engine.engine});
    return finding;
}

}  // namespace

Result<Finding> timeByResolution(const BenchSite& site, const Extent& extent, const StartList& engines,
                                 const Work& work) {
    if (extent.resolutions.empty()) return failure("No resolution fits a square of this size");
    Finding finding = emptyFinding(site, extent, engines);
    Pieces pieces(work, "time by resolution", extent.resolutions.size());
    for (const int resolution : extent.resolutions) {
        pieces.next();
        const auto placings = placingsAt(resolution, site, extent, engines, work);
        if (!placings) return tl::make_unexpected(placings.error());
        addTo(finding, resolution, engines, *placings);
    }
    addGrowth(finding);
    return finding;
}

}  // namespace noonmark::bench
