#pragma once

#include <string>
#include <vector>

#include "core/bench/contests/contest.h"
#include "core/bench/contests/site.h"

namespace noonmark::bench {

/// Name of the inverse accrual map's setting without the direction graph: every hour of every day is
/// computed.
inline constexpr const char* withoutGraph = "no graph";

/// The contest of all engines and settings over one period, in the middle of the city.
struct PeriodRun {
    std::string name;  ///< "a day"; empty if only the number of days matters
    int days = 1;
    double hours = 6;  ///< per day
    std::vector<Contestant> contestants;
    std::vector<Placing> placings;  ///< in the order of the contestants
};

/// Runs contests over the hour from noon, then over Extent::dayCounts days of 6 h from 9:00; the first day is
/// the site's date. The hour and the periods of 1, 30 and 365 days have a name and run every setting; the
/// other periods run the default settings, and the inverse accrual map without its direction graph.
///
/// Over more than a day the truth is a sample of receivers, and the ray reference's time is extrapolated from
/// it. A contestant that was too slow over one period, or is predicted to be, is left out of longer ones.
/// Settings other than the defaults run after those, as many as fit into the allowance, in each period
/// those of the fastest engines first.
Result<std::vector<PeriodRun>> benchPeriods(const BenchSite& site, const Extent& extent,
                                            const EngineList& engines, const Work& work);

/// The contest of all engines at one resolution of the square in the middle of the city.
struct ResolutionRun {
    int cellsASide = 0;
    std::vector<Placing> placings;  ///< in the order of the engines
};

/// Runs the hour from noon of the site's date at each of Extent::resolutions, coarsest first. All engines run
/// at the first two; at finer ones as many as time allows. Error if no resolution is possible.
Result<std::vector<ResolutionRun>> benchResolutions(const BenchSite& site, const Extent& extent,
                                                    const StartList& engines, const Work& work);

/// For pages: " at 1024" if the finest resolution measured is not the finest requested; else nothing.
std::string unlessAt(int finest, double cellsASide);

}  // namespace noonmark::bench
