#pragma once

#include <cstddef>

#include "core/sun/sun_steps.h"
#include "render/view/explored_view.h"

namespace noonmark {

/// One unit of work on a view: some days of all points, or few days of some points. A test is one point at
/// one step.
struct ViewTurn {
    std::size_t firstPoint = 0;
    std::size_t points = 0;
    int days = 1;
    double tests = 0;
};

/// Smallest turn worth its overhead: some hundredths of a second of rays.
inline constexpr double minTurnTests = 1e6;
/// Size of the first turn, before the machine's speed is known.
inline constexpr double firstTurnTests = 5e6;

/// Mean number of steps per day with the sun up, over the period.
double stepsADay(const SunSteps& sun);

/// How many days of `points` a coarse level takes, 1 to all: as many as take about a tenth of a second.
int coarseDays(std::size_t points, const SunSteps& sun);

/// How many days of a view are wanted. The first few are computed together, so that a finer view never covers
/// less of the period than the coarser one before it.
struct WantedDays {
    int first = 1;
    int all = 1;
};

/// The next turn of a view: at most `maxTests` tests, but at least one point.
ViewTurn nextTurn(const ExploredView& view, const WantedDays& wanted, const SunSteps& sun, double maxTests);

/// The rest of `days`, in one turn.
ViewTurn allTheRest(const ExploredView& view, int days, const SunSteps& sun);

/// The points and the days of a turn. Days are ordered so that each prefix is spread over the period.
SurfacePoints pointsOf(const SurfacePoints& all, const ViewTurn& turn);
SunSteps daysOf(const SunSteps& sun, int first, int count);

/// Adds the result of a turn: gross is a mean over days, continuous the maximum over days.
void join(ExploredView& view, const ViewTurn& turn, const SurfaceShadow& found);

}  // namespace noonmark
