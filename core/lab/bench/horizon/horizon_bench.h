#pragma once

// The folder core/lab/bench/horizon measures the two exact engines against their targets. runHorizonBench()
// (this file) runs the experiments: a year by the horizon sweep and its growth with receivers and buildings
// (horizon_year.cpp), a day by projected shadows (horizon_bench.cpp), and edits with cached horizons and with
// cached shadows (horizon_edits.cpp), which both make the same edit.

#include <array>

#include "core/engines/api/engine_registry.h"
#include "core/lab/bench/bench_report.h"
#include "core/lab/bench/contests/site.h"
#include "core/lab/bench/finding.h"
#include "core/lab/bench/work.h"

namespace noonmark::bench {

/// The numbers of the two exact engines against their targets: the horizon sweep over a year, with the curves
/// of error and time; projected shadows over a day; edits with cached horizons and cached shadows. Errors as
/// in runPaperBench.
Result<BenchReport> runHorizonBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                    Progress& progress, const std::stop_token& stop);

/// The keys of its findings, in order.
inline constexpr std::array horizonBenchKeys{"horizon_year", "projected_day", "horizon_edits", "day_edits",
                                             "horizon_scale"};

/// How much time cached horizons save in a study of a year of 8 h days: the hours of a day are changed, and
/// one tower of 40 x 40 x 200 m is moved by 10 m and back, each against the full sweep. The edited field is
/// compared bit for bit with a fresh one. Summary: retime_fraction, edit_fraction, edit_ms (for a tower that
/// has moved before), edit_first_ms.
Result<Finding> benchHorizonEdits(const BenchSite& site, const Extent& extent, const Work& work);

/// How much time cached shadows save in a study of one day of 6 h at every minute, gross and continuous: a
/// tower of 200 m is moved by 10 m and back, in turn with full runs of projected shadows. The edited field is
/// compared bit for bit with a fresh one before its time counts. Summary: day_edit_fraction, day_edit_ms.
Result<Finding> benchDayEdits(const BenchSite& site, const Extent& extent, const Work& work);

/// A year of 8 h days at every minute by the horizon sweep, at several bin widths, compared with the ray
/// reference on a sample of receivers; the ray reference's time for all receivers is extrapolated. Summary:
/// year_vs_ray, year_cell_error_mean_pct, year_cell_error_max_pct, at the default bin width.
Result<Finding> benchHorizonYear(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                 const Work& work);

/// How the time of the horizon sweep over a year of 8 h days grows with the number of receivers (squares of
/// an eighth to the whole side), and with the number of buildings in the city, nearest to the middle first,
/// most of them out of reach.
Result<Finding> benchHorizonScale(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
