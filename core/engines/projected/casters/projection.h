#pragma once

#include <atomic>
#include <cstddef>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/projected/counting/run_starts.h"
#include "core/engines/projected/filling/step_filler.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Fills the shadows of casters at the steps of a period and counts the receivers' minutes, window by window,
/// so that the raster and the counts of a window stay in cache. Uses all cores.
class ShadowProjection {
public:
    /// All arguments except `stop` must outlive this object.
    ShadowProjection(const ShadowCasters& casters, const Receivers& receivers, const SunSteps& sun,
                     Progress& progress, std::stop_token stop);

    /// Writes minutes to the receivers' cells of a blank field. Error: cancelled().
    Result<FillCount> run(ShadowField& field);

private:
    FillCount count(const FillWindow& window, ShadowField& field);
    bool goOn();

    const ShadowCasters& casters_;
    const Receivers& receivers_;
    const SunSteps& sun_;
    ReceiverCount where_;
    std::vector<RunStarts> starts_;
    std::vector<FillWindow> windows_;
    Progress& progress_;
    std::stop_token stop_;
    std::atomic<std::size_t> done_{0};  // steps x windows
};

}  // namespace noonmark
