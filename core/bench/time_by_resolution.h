#pragma once

#include "core/bench/contestant.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/site.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// How engines scale with the number of cells (paper, section 7, Figure b of the performance evaluation): the
/// square in the middle of the city cut into Extent::resolutions cells a side, one hour from noon of the
/// site's date at every minute.
Result<Finding> timeByResolution(const BenchSite& site, const Extent& extent, const StartList& engines,
                                 const Work& work);

}  // namespace noonmark::bench
