#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "app/gui/session/study/open_city.h"
#include "core/engines/api/engine.h"
#include "core/engines/api/shadow_field.h"
#include "core/lab/graph/interval_tally.h"
#include "core/sun/sun_steps.h"
#include "render/view/explored_view.h"
#include "render/view/section_box.h"

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

/// What to compute for a view. Copies are cheap.
struct ViewQuestion {
    std::shared_ptr<const OpenCity> city;
    CameraPose pose;
    ViewLens lens;  ///< device pixels
    Period period;
    Observer observer;                    ///< place from which the sun is seen
    std::shared_ptr<const SunSteps> sun;  ///< of the period, if already known
    double turnTests = firstTurnTests;    ///< see turnTestsAfter()
    std::optional<SectionBox> section{};  ///< only what lies inside is seen
};

/// The state of a view's refinement. Immutable: each refinement creates a new one.
struct ViewAnswer {
    ExploredView view;
    std::shared_ptr<const SunSteps> sun;
    int level = 0;       ///< in refinementSpacingsPx
    int coarseDays = 1;  ///< days that a level takes before a finer one begins
    bool first = false;  ///< the first answer for a view
    ViewTurn turn;       ///< the last one
    double turnSeconds = 0;
    /// Shadow of its samples at each step, and of the coarser level's samples around each of them, if the
    /// engine works by steps and the period is one day; else null.
    std::shared_ptr<const EdgeMasks> steps;
    std::shared_ptr<const StepsAround> around;
};

/// The engine that computes the samples.
struct ViewEngine {
    std::shared_ptr<const SurfaceEngine> accumulator;
    /// Its cost grows with points and days, so that a level can be computed in parts. Otherwise computing all
    /// at once is the cheapest, and the engine delivers partial results.
    bool inParts = true;
};

/// Pixels between samples, from coarse to fine. The first level is skipped if the second is fast enough.
inline constexpr int refinementSpacingsPx[] = {16, 8, 4, 2, 1};

/// The number of tests for the next turn, so that five pictures per second are possible, judging by the speed
/// of the last turn.
double turnTestsAfter(const ViewAnswer& answer);

/// The next answer: first a coarse level (`before` is null), then finer ones. Each level starts with the
/// values of the coarser one and then computes its own points and days in turns; the finest takes all days,
/// the others as many as the first. Each answer is correct for the samples and days that it states. Error: a
/// period out of range, a sun that never rises; cancelled() within 0.2 s.
Result<ViewAnswer> refineView(const ViewQuestion& question, const ViewAnswer* before,
                              const ViewEngine& engine, Progress& progress, std::stop_token stop);

/// Combines `answer` with a partial result of its next turn, if that shows more than the answer does: more
/// samples times days than the coarser level behind it, or the whole period in finer detail; else nothing.
std::optional<ViewAnswer> withRunning(const ViewAnswer& answer, const PartialField& running);

/// Whether nothing is left to refine.
bool isFinest(const ViewAnswer& answer);

}  // namespace noonmark
