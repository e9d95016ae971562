#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/common/open_below.h"
#include "core/engines/common/sun_packets.h"
#include "core/engines/horizon/counting/run_search.h"
#include "core/engines/ray/ray_scene.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Traces the rays of RayReference for longest runs that horizons leave in doubt (run_doubts.h).
class RunRays {
public:
    /// `city`, `receivers` and `sun` must outlive it. `used`: indices of the buildings in reach. Error if
    /// memory runs out; cancelled().
    static Result<RunRays> over(const City& city, std::span<const std::uint32_t> used,
                                const Receivers& receivers, const SunSteps& sun, bool checksRuns,
                                const std::stop_token& stop);

    /// Whether every step of a run is looked at.
    [[nodiscard]] bool checkRuns() const { return checksRuns_; }

    /// Number of steps that are traced at once.
    static constexpr std::size_t together = std::size_t(DirectionPacket::capacity);

    /// The rays of one receiver; steps are indices in the period.
    class Receiver {
    public:
        [[nodiscard]] bool hidden(std::uint32_t step) const;
        /// Bit k: steps[k] is lit. At most `together` steps.
        [[nodiscard]] std::uint32_t findLit(std::span<const std::uint32_t> steps) const;
        /// A lit step in [first, end), if any.
        [[nodiscard]] std::optional<std::uint32_t> findLit(std::uint32_t first, std::uint32_t end) const;
        /// The same for a search, which looks at every step of a run only if runs are checked.
        [[nodiscard]] RunSearch::Rays forSearch() const;

    private:
        friend RunRays;
        Receiver(const RunRays& rays, glm::vec3 origin) : rays_(&rays), origin_(origin) {}
        const RunRays* rays_;
        glm::vec3 origin_;
    };
    [[nodiscard]] Receiver of(std::uint32_t cell) const;

    [[nodiscard]] glm::vec3 positionOf(std::uint32_t cell) const { return receivers_.position(cell); }
    /// Where the rays may find light below parts that horizons count as solid.
    [[nodiscard]] std::span<const OpenBelow> openBelow() const { return openBelow_; }

    void countReceiver() { ++decided_->receivers; }
    [[nodiscard]] std::uint64_t receivers() const { return decided_->receivers; }  ///< decided by rays
    [[nodiscard]] std::uint64_t rays() const { return decided_->rays; }

private:
    struct Decided {
        std::atomic<std::uint64_t> receivers{0}, rays{0};
    };
    RunRays(RayScene scene, std::vector<OpenBelow> openBelow, const Receivers& receivers, const SunSteps& sun,
            bool checksRuns)
        : scene_(std::move(scene)),
          openBelow_(std::move(openBelow)),
          receivers_(receivers),
          sun_(sun),
          checksRuns_(checksRuns) {}

    RayScene scene_;
    std::vector<OpenBelow> openBelow_;
    const Receivers& receivers_;
    const SunSteps& sun_;
    bool checksRuns_;
    std::unique_ptr<Decided> decided_ = std::make_unique<Decided>();
};

}  // namespace noonmark
