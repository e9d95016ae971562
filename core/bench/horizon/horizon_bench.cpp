#include "core/bench/horizon/horizon_bench.h"

#include <limits>

#include "core/bench/horizon/day_edits.h"
#include "core/bench/horizon/horizon_edits.h"
#include "core/bench/horizon/horizon_scale.h"
#include "core/bench/horizon/horizon_year.h"
#include "core/bench/horizon/projected_day.h"
#include "core/bench/paper/experiments.h"

namespace noonmark::bench {

namespace {

std::vector<SummaryFigure> horizonSummary() {
    return {
        targetFigure("year_vs_ray", "a year's gross shadow by the horizon sweep, times as fast as rays",
                     atLeast(2000)),
        {"year_with_runs_vs_ray", "the same with continuous shadow", ""},
        targetFigure("year_cell_error_mean_pct", "its cell error, mean, % of the year", atMost(0.05)),
        targetFigure("year_cell_error_max_pct", "its cell error, largest, %", atMost(0.5)),
        targetFigure("day_vs_ray", "a day by projected shadows, times as fast as rays", atLeast(25)),
        targetFigure("day_mistagged_pct", "cells and minutes mistagged by projected shadows, %",
                     atMost(0.001)),
        targetFigure("retime_fraction",
                     "other hours with cached horizons, gross, as a share of the full sweep", atMost(0.05)),
        {"retime_with_runs_fraction", "the same with continuous shadow", ""},
        targetFigure("edit_fraction", "a tower moved by 10 m, gross, as a share of the full sweep",
                     atMost(0.02)),
        {"edit_with_runs_fraction", "the same with continuous shadow", ""},
        {"edit_ms", "a tower moved by 10 m, gross, ms", "< 33"},
        targetFigure(
            "day_edit_fraction",
            "the same over a day by projected shadows, with continuous shadow, as a share of a full run",
            atMost(0.05)),
        {"day_edit_ms", "the same, ms", ""}};
}

}  // namespace

Result<BenchReport> runHorizonBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                    Progress& progress, const std::stop_token& stop) {
    if (const auto fits = check(site); !fits) return tl::make_unexpected(fits.error());
    const Work work{progress, stop};
    Extent patient = extent;  // its numbers are compared with targets: never from a single run
    patient.onceAboveS = std::numeric_limits<double>::infinity();
    Experiments experiments(work);
    experiments.add("A year by the horizon sweep",
                    [&](const Work& its) { return benchHorizonYear(site, patient, engines, its); });
    experiments.add("One day, every engine",
                    [&](const Work& its) { return benchProjectedDay(site, patient, engines, its); });
    experiments.add("Other hours, and a moved tower",
                    [&](const Work& its) { return benchHorizonEdits(site, extent, its); });
    experiments.add("A tower is moved, one day",
                    [&](const Work& its) { return benchDayEdits(site, extent, its); });
    experiments.add("Growth of the horizon sweep",
                    [&](const Work& its) { return benchHorizonScale(site, extent, its); });
    return std::move(experiments)
        .into({.title = "The exact engines against their targets",
               .reference = "target",
               .summary = horizonSummary()},
              site, extent);
}

}  // namespace noonmark::bench
