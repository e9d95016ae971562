#pragma once

#include <cstddef>

#include "core/sun/sun_steps.h"
#include "render/view/explored_view.h"

namespace noonmark {

/// What is done of a view in one go: some days of all points, or few days of some points. A test is one point
/// at one step.
struct ViewTurn {
    std::size_t firstPoint = 0;
    std::size_t points = 0;
    int days = 1;
    double tests = 0;
};

/// A turn is worth its overhead from here on: some hundredth of a second of rays.
inline constexpr double leastTurnTests = 1e6;
/// Before the machine is known.
inline constexpr double firstTurnTests = 5e6;

/// Steps of a day with the sun up, at the mean of the period.
double stepsADay(const SunSteps& sun);

/// How many days of `points` a coarse level takes, 1 to all: those that some tenth of a second is enough for.
int coarseDays(std::size_t points, const SunSteps& sun);

/// How many days of a view are wanted. The first few come together, so that a finer view never tells less of
/// the period than the coarser one before it.
struct WantedDays {
    int first = 1;
    int all = 1;
};

/// The next turn of a view: `mostTests` or a little less, at least one point.
ViewTurn nextTurn(const ExploredView& view, const WantedDays& wanted, const SunSteps& sun, double mostTests);

/// All that is left of `days`, in one turn.
ViewTurn allTheRest(const ExploredView& view, int days, const SunSteps& sun);

/// The points and days of a turn. Days follow each other in an order of which every beginning is spread over
/// the period.
SurfacePoints pointsOf(const SurfacePoints& all, const ViewTurn& turn);
SunSteps daysOf(const SunSteps& sun, int first, int count);

/// Adds what a turn found: gross is a mean over days, continuous the longest of any day.
void join(ExploredView& view, const ViewTurn& turn, const SurfaceShadow& found);

}  // namespace noonmark
