#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/points/horizons/point_run_rays.h"
#include "core/engines/points/horizons/sun_track.h"

namespace noonmark {

/// Decides the longest unbroken times of points by rays, at the steps that the bounds of the horizon leave in
/// doubt: those of the runs that horizons find, and of all runs that could be longer. Afterwards they are off
/// by at most `allowed` steps, but for what docs/user/limits.md names. Reuses its memory; one per thread.
class PointRunSearch {
public:
    static constexpr int allowed = 2;

    /// `track` must outlive it.
    explicit PointRunSearch(const SunTrack& track) : track_(track) {}

    [[nodiscard]] PointRuns decide(const BinHorizon& horizon, const HorizonBounds& bounds,
                                   const PointRunRays& rays);

private:
    /// What is known of one point.
    struct Point {
        const BinHorizon& horizon;
        const HorizonBounds& bounds;
        const PointRunRays& rays;
    };
    /// A step that the bounds leave in doubt.
    struct Doubt {
        std::uint32_t step;
        std::uint16_t bin;
        bool isLikelyEnd;       ///< according to the horizon
        bool isWithin = false;  ///< a ray found that it does not end the run
    };
    /// Which doubts to look at.
    enum class Which { inEndBins, likelyEnds, all };
    [[nodiscard]] bool isWanted(const Doubt& doubt, Which which) const;
    [[nodiscard]] std::uint32_t longest(const TrackRun& found, const Point& point);
    void findDoubts(const TrackRun& run, const Point& point);
    [[nodiscard]] bool holds(const TrackRun& run, const PointRunRays& rays);
    void search(TrackRun run, const PointRunRays& rays);
    [[nodiscard]] std::optional<std::uint32_t> findEnd(const TrackRun& run, const PointRunRays& rays);
    [[nodiscard]] std::optional<std::uint32_t> findEndAmong(std::span<Doubt> doubts, std::uint32_t middle,
                                                            Which which, const PointRunRays& rays);
    [[nodiscard]] std::uint32_t findEnds(std::span<Doubt* const> doubts, const PointRunRays& rays) const;

    const SunTrack& track_;
    std::vector<Doubt> doubts_;  // of the current run, ascending
    std::vector<Doubt*> asked_;
    std::array<std::uint8_t, SunBins::count> isEndBin_{};  // whether a step of the bin ended a run
    bool ofShadow_ = true;
    std::uint32_t longest_ = 0;
};

}  // namespace noonmark
