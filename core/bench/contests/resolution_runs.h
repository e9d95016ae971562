#pragma once

#include "core/bench/contests/contest.h"
#include "core/bench/contests/site.h"

namespace noonmark::bench {

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
