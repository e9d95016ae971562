#pragma once

#include <memory>

#include "app/window/open_city.h"
#include "render/explored_view.h"

namespace noonmark {

/// What a view is explored for. Copies are cheap.
struct ViewQuestion {
    std::shared_ptr<const OpenCity> city;
    CameraPose pose;
    ViewLens lens;  ///< device pixels
    Period period;
    Observer observer;                    ///< from where the sun is seen
    std::shared_ptr<const SunSteps> sun;  ///< of the period, where known already
};

/// What is known of a view so far. Immutable: each refinement makes a new one.
struct ViewAnswer {
    ExploredView view;
    std::shared_ptr<const SunSteps> sun;
    int level = 0;  ///< in refinementLevels
};

/// What shades the samples.
struct SurfaceEngine {
    std::shared_ptr<const SurfaceAccumulator> accumulator;
    /// Its cost grows with the points and days asked for, so that the finest level may be taken in parts;
    /// else all of it at once is the cheapest.
    bool inParts = true;
};

/// From coarse to fine. A turn costs no more than `mostTests` tests of one sample at one step, where one day
/// allows it: of a long period a coarse level takes as many days, scattered over the whole of it. The finest
/// level takes all days, in turns of some days, or of some points on one day.
struct RefinementLevel {
    int spacingPx = 1;
    double mostTests = 0;
};
inline constexpr RefinementLevel refinementLevels[] = {{8, 1e7}, {4, 2e7}, {2, 4e7}, {1, 5e7}};

/// The next answer: the coarsest level without one before (null), then finer ones, then more points and days
/// of the finest. Each is true for the samples and days that it says. Error: a period out
/// of range, a sun that never rises; cancelled() within 0.2 s.
Result<ViewAnswer> refined(const ViewQuestion& question, const ViewAnswer* before,
                           const SurfaceEngine& engine, Progress& progress, std::stop_token stop);

/// Nothing is left to refine.
bool isFinest(const ViewAnswer& answer);

}  // namespace noonmark
