#pragma once

#include "core/lab/bench/contests/site.h"
#include "core/lab/bench/work.h"
#include "core/samples/sample_city.h"

namespace noonmark::bench::tests {

/// 100 buildings, squares of 60 m: all experiments together take seconds.
inline BenchSite tinySite() {
    BenchSite site;
    site.city = makeGridSample({.buildings = 100}).value();
    site.name = "tiny grid";
    site.sideM = 60;
    return site;
}

/// One of each quantity.
inline Extent minExtent() {
    Extent extent;
    extent.sunTimes = 100;
    extent.hours = 2;
    extent.graphHours = 2;
    extent.graphPositions = 1;
    extent.positions = 1;
    extent.days = 2;
    extent.hoursADay = 1;
    extent.resolutions = {16, 32};
    extent.dayCounts = {1, 3};
    extent.factors = {1, 2};
    extent.runs = 1;
    extent.sampleReceivers = 100;
    extent.words = "One of everything.";
    return extent;
}

}  // namespace noonmark::bench::tests
