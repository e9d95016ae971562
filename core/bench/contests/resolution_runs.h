#pragma once

#include "core/bench/contests/contest.h"
#include "core/bench/contests/site.h"

namespace noonmark::bench {

/// All engines at one resolution of the square in the middle of the city.
struct ResolutionRun {
    int cellsASide = 0;
    std::vector<Placing> placings;  ///< of the engines
};

/// The hour from noon of the site's date at each of Extent::resolutions, coarsest first. An engine takes part
/// in the finer ones as far as there is time, in the first two in any case. Error where there is none.
Result<std::vector<ResolutionRun>> benchResolutions(const BenchSite& site, const Extent& extent,
                                                    const StartList& engines, const Work& work);

/// For pages: " at 1024" where the finest measured is not the finest asked for; else nothing.
std::string unlessAt(int finest, double cellsASide);

}  // namespace noonmark::bench
