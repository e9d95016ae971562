#include "core/lab/bench/horizon/horizon_bench.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>

#include "core/engines/projected/filling/bit_raster.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/lab/bench/contests/contest.h"
#include "core/lab/bench/contests/moments.h"
#include "core/lab/bench/contests/ray_masks.h"
#include "core/lab/bench/finding.h"
#include "core/lab/bench/paper/paper_bench.h"

namespace noonmark::bench {

namespace {

std::size_t differences(const std::vector<ShadowMask>& masks, std::span<const std::uint64_t> rasters,
                        const Receivers& receivers) {
    const BitLayout layout(receivers.grid);
    const std::size_t steps = rasters.size() / layout.words();
    std::size_t count = 0;
    for (std::size_t i = 0; i < masks.size(); ++i) {
        const int column = int(receivers.cells[i]) % layout.columns;
        const int row = int(receivers.cells[i]) / layout.columns;
        for (std::size_t step = 0; step < steps; ++step) {
            const bool filled = layout.at(rasters.subspan(step * layout.words()), column, row);
            count += std::size_t(filled != ((masks[i] >> step & 1U) != 0));
        }
    }
    return count;
}

// A mask holds 64 steps, so the day is processed in stretches.
Result<double> mistaggedPct(const Scene& scene, const Work& work) {
    const auto rays = RayMasks::over(scene.city, scene.receivers, work.stop);
    if (!rays) return tl::make_unexpected(rays.error());
    std::size_t wrong = 0;
    for (std::size_t first = 0; first < scene.sun.steps.size(); first += maxMaskSteps) {
        if (work.stopped()) return cancelled();
        const SunSteps stretch =
            sliceSteps(scene.sun, first, std::min<std::size_t>(maxMaskSteps, scene.sun.steps.size() - first));
        const auto rasters = computeShadowRasters(scene.city, scene.receivers, stretch);
        if (!rasters) return tl::make_unexpected(rasters.error());
        std::vector<glm::dvec3> directions;
        for (const SunStep& step : stretch.steps) directions.emplace_back(step.direction);
        wrong += differences(rays->of(directions), *rasters, scene.receivers);
    }
    return 100 * double(wrong) / (double(scene.receivers.cells.size()) * double(scene.sun.steps.size()));
}

void addTo(Finding& finding, const Contestant& engine, const Placing& placing, double raySeconds) {
    TableCell seconds;
    if (placing.timed()) seconds = placing.medianS;
    finding.table.rows.push_back({engine.engine, seconds, double(placing.runs), placing.error.areaPct,
                                  placing.error.cellMeanPct, placing.error.cellMaxPct, placing.refusal});
    if (!placing.timed()) {
        finding.remarks.push_back(engine.name + ": " + placing.refusal);
        return;
    }
    finding.comparisons[0].rows.push_back(
        {engine.name, formatThreeDigits(placing.medianS), formatThreeDigits(raySeconds / placing.medianS),
         fmt::format("{:.4f}", placing.error.cellMeanPct), fmt::format("{:.2f}", placing.error.cellMaxPct)});
    finding.charts[0].series.push_back(
        {.name = engine.name,
         .colourOf = engine.engine,
         .points = {{std::max(1e-4, placing.error.cellMeanPct), placing.medianS, {}}},
         .joined = false});
    if (engine.engine == "projected") finding.summary["day_vs_ray"] = raySeconds / placing.medianS;
}

Finding emptyFinding(const BenchSite& site, const Extent& extent) {
    Finding finding;
    finding.key = "projected_day";
    finding.title = "One day, every engine";
    finding.text = fmt::format(
        "6 h around noon on {} at every minute, gross and continuous, in the middle of the city, all engines "
        "in turn; medians of {} runs. Errors are of the sunlit time; an error of zero is shown as 0.0001 %.",
        formatText(site.date), extent.runs);
    finding.table.columns = {
        "engine", "time_s", "runs", "area_error_pct", "cell_error_mean_pct", "cell_error_max_pct", "refusal"};
    finding.comparisons[0].header = {"engine", "s", "x rays", "error, %", "largest"};
    finding.charts = {{"Time against error", {"cell error, mean, %", true}, {"time, s", true}, {}}};
    return finding;
}

/// One day of 6 h at every minute by every engine, in turn with the ray reference; projected shadows also
/// minute by minute. Summary: day_vs_ray and day_mistagged_pct, the share of cells and minutes in which
/// projected shadows and rays differ.
Result<Finding> benchProjectedDay(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                  const Work& work) {
    work.progress.report(0, "one day, every engine");
    const auto receivers = pickMiddleReceivers(site, work.stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    const auto sun = computeSunOver(site, site.date, 1);
    if (!sun) return tl::make_unexpected(sun.error());
    const Scene scene{site.city, *receivers, *sun};
    const auto truth = computeTruth(scene, *receivers, work);
    if (!truth) return tl::make_unexpected(truth.error());
    const StartList list = listDefaultEngines(engines);
    const auto placings = runContest(scene, list.contestants, *truth, extent, work);
    if (!placings) return tl::make_unexpected(placings.error());
    Finding finding = emptyFinding(site, extent);
    const auto ray = std::ranges::find(list.contestants, "ray", &Contestant::engine);
    const double raySeconds = ray == list.contestants.end()
                                  ? secondsForAll(*truth, *receivers)
                                  : (*placings)[std::size_t(ray - list.contestants.begin())].medianS;
    for (std::size_t i = 0; i < placings->size(); ++i)
        addTo(finding, list.contestants[i], (*placings)[i], raySeconds);
    const auto mistagged = mistaggedPct(scene, work);
    if (!mistagged && isCancelled(mistagged.error())) return tl::make_unexpected(mistagged.error());
    if (mistagged) finding.summary["day_mistagged_pct"] = *mistagged;
    return finding;
}

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
