#pragma once

#include <memory>
#include <optional>

#include "app/window/study/open_city.h"
#include "app/window/view/view_turn.h"
#include "core/engines/api/partial_field.h"
#include "core/engines/api/surface_engine.h"
#include "core/engines/graph/steps_around.h"
#include "render/view/explored_view.h"

namespace noonmark {

/// What a view is explored for. Copies are cheap.
struct ViewQuestion {
    std::shared_ptr<const OpenCity> city;
    CameraPose pose;
    ViewLens lens;  ///< device pixels
    Period period;
    Observer observer;                    ///< from where the sun is seen
    std::shared_ptr<const SunSteps> sun;  ///< of the period, where known already
    double turnTests = firstTurnTests;    ///< see turnTestsAfter()
};

/// What is known of a view so far. Immutable: each refinement makes a new one.
struct ViewAnswer {
    ExploredView view;
    std::shared_ptr<const SunSteps> sun;
    int level = 0;       ///< in refinementSpacingsPx
    int coarseDays = 1;  ///< that a level takes before a finer one begins
    bool first = false;  ///< of a view
    ViewTurn turn;       ///< the last one
    double turnSeconds = 0;
    /// Its samples step by step, and those of the coarser level around each of its samples, where the engine
    /// works by steps and the period is one day; else null.
    std::shared_ptr<const EdgeMasks> steps;
    std::shared_ptr<const StepsAround> around;
};

/// What shades the samples.
struct ViewEngine {
    std::shared_ptr<const SurfaceEngine> accumulator;
    /// Its cost grows with the points and days asked for, so that a level may be taken in parts; else all of
    /// it at once is the cheapest, and the engine hands out running results.
    bool inParts = true;
};

/// Pixels from sample to sample, from coarse to fine. The first is left out where the second is quick enough.
inline constexpr int refinementSpacingsPx[] = {16, 8, 4, 2, 1};

/// How many tests the next turn may take, to end in time for five pictures a second on the machine that did
/// the last one.
double turnTestsAfter(const ViewAnswer& answer);

/// The next answer: a coarse level without one before (null), then finer ones, each at first with what the
/// coarser one knew, then in turns with its own points and days; the finest takes all days, the others as
/// many as the first. Each answer is true for the samples and days that it says. Error: a period out of
/// range, a sun that never rises; cancelled() within 0.2 s.
Result<ViewAnswer> refined(const ViewQuestion& question, const ViewAnswer* before, const ViewEngine& engine,
                           Progress& progress, std::stop_token stop);

/// With a running result of the turn that follows `answer`, where that says more than the answer does: more
/// samples times days than the coarser level behind it, or all of the period in finer detail; else nothing.
std::optional<ViewAnswer> withRunning(const ViewAnswer& answer, const PartialField& running);

/// Nothing is left to refine.
bool isFinest(const ViewAnswer& answer);

}  // namespace noonmark
