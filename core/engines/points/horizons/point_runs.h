#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/points/horizons/sun_track.h"
#include "core/engines/ray/ray_scene.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The rays of one point on a surface, for the steps that its longest runs depend on. Scene and sun must
/// outlive it.
class PointRunRays {
public:
    /// Number of steps that are traced at once.
    static constexpr std::size_t together = std::size_t(DirectionPacket::capacity);

    PointRunRays(const RayScene& scene, const SunSteps& sun, glm::vec3 position, glm::vec3 normal);

    /// Bit k: the point is in shadow at steps[k], or turned away from its sun. At most `together` steps.
    [[nodiscard]] std::uint32_t findShaded(std::span<const std::uint32_t> steps) const;

    [[nodiscard]] std::uint64_t rays() const { return rays_; }

private:
    [[nodiscard]] bool isShaded(glm::vec3 sun) const;

    const RayScene& scene_;
    const SunSteps& sun_;
    glm::vec3 origin_, normal_;
    mutable std::uint64_t rays_ = 0;
};

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
