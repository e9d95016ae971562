#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/points/horizons/point_run_rays.h"
#include "core/engines/points/horizons/sun_track.h"

namespace noonmark {

/// Decides the longest unbroken times of points by rays: those that horizons find are confirmed step by step,
/// and where they are not, or where the horizons beside could make them longer, the days that may hold a
/// longer one are searched. Afterwards they are off by at most `allowed` steps, except for an occluder or
/// gap that no bin sees within a run that is not the longest. Reuses its memory; one per thread.
class PointRunSearch {
public:
    static constexpr int allowed = 2;

    /// `track` and `suns` must outlive it.
    PointRunSearch(const SunTrack& track, const SunBins& suns) : track_(track), suns_(suns) {}

    [[nodiscard]] PointRuns decide(const BinHorizon& horizon, const PointRunRays& rays);

private:
    [[nodiscard]] std::uint32_t longest(const TrackRun& found, const BinHorizon& horizon,
                                        const BinHorizon& most, const PointRunRays& rays);
    [[nodiscard]] bool holds(const TrackRun& run, const PointRunRays& rays);
    void search(TrackRun run, const BinHorizon& horizon, const PointRunRays& rays);
    [[nodiscard]] std::optional<std::uint32_t> findEnd(const TrackRun& run, const BinHorizon& horizon,
                                                       const PointRunRays& rays);
    void collect(const TrackRun& run, const BinHorizon& horizon, bool likely);
    [[nodiscard]] std::optional<std::uint32_t> findEndAmongSteps(const PointRunRays& rays) const;

    const SunTrack& track_;
    const SunBins& suns_;
    BinHorizon highest_, lowest_;
    std::vector<std::uint32_t> steps_;
    bool ofShadow_ = true;
    std::uint32_t longest_ = 0;
};

/// The highest horizon of each bin and its neighbours, with the space below overhangs filled; the lowest,
/// without overhangs. Bins without suns are left out.
void widenHorizon(const BinHorizon& horizon, const SunBins& suns, BinHorizon& highest, BinHorizon& lowest);

}  // namespace noonmark
