#pragma once

#include <string>
#include <vector>

#include "core/bench/contests/contest.h"
#include "core/bench/contests/site.h"

namespace noonmark::bench {

/// The setting of the inverse accrual map that computes every hour of every day anew.
inline constexpr const char* withoutGraph = "no graph";

/// All engines and settings over one period, in the middle of the city.
struct PeriodRun {
    std::string name;  ///< "a day"; empty where only the number of days matters
    int days = 1;
    double hours = 6;  ///< a day
    std::vector<Contestant> contestants;
    std::vector<Placing> placings;  ///< of the contestants
};

/// The hour from noon, then Extent::dayCounts days of 6 h from 9:00, the first one the site's date. An hour,
/// a day, 30 and 365 days have a name, and every setting; the other periods have the usual ones, and the
/// inverse accrual map without its direction graph.
///
/// Over more than a day the truth is a sample of receivers, and the ray reference's time is worked out from
/// it. Who was too slow over one period, or must be expected to be, is left out of the longer ones. Of the
/// settings that are not usual as many are tried as the allowance has room for after those that are, in each
/// period the ones of the quickest engines first.
Result<std::vector<PeriodRun>> benchPeriods(const BenchSite& site, const Extent& extent,
                                            const EngineList& engines, const Work& work);

}  // namespace noonmark::bench
