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
#include "core/engines/common/sun_packets.h"
#include "core/engines/horizon/counting/run_search.h"
#include "core/engines/ray/ray_scene.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The rays of RayReference for longest runs that horizons leave in doubt (run_doubts.h).
class RunRays {
public:
    /// `city`, `receivers` and `sun` must outlive it. `used`: indices of the buildings in reach. Error:
    /// memory runs out, or cancelled().
    static Result<RunRays> over(const City& city, std::span<const std::uint32_t> used,
                                const Receivers& receivers, const SunSteps& sun, bool checksRuns,
                                const std::stop_token& stop);

    /// Of one receiver. With `checksRuns` findLit is there too: a gap narrower than a bin that holds several
    /// steps of a day is met on every day, and no bin may see it; steps that are farther apart pass it on the
    /// best day.
    [[nodiscard]] RunSearch::Rays of(std::uint32_t cell);

    /// Whether of() has findLit.
    [[nodiscard]] bool checkRuns() const { return !packets_.empty(); }

    void countReceiver() { ++decided_->receivers; }
    [[nodiscard]] std::uint64_t receivers() const { return decided_->receivers; }  ///< that rays decided
    [[nodiscard]] std::uint64_t rays() const { return decided_->rays; }

private:
    struct Decided {
        std::atomic<std::uint64_t> receivers{0}, rays{0};
    };
    RunRays(RayScene scene, const Receivers& receivers, const SunSteps& sun, bool checksRuns);
    [[nodiscard]] bool hidden(glm::vec3 origin, std::uint32_t step) const;
    [[nodiscard]] std::optional<std::uint32_t> findLit(glm::vec3 origin, std::uint32_t first,
                                                       std::uint32_t end) const;

    RayScene scene_;
    const Receivers& receivers_;
    const SunSteps& sun_;
    std::vector<SunPacket> packets_;  // none: runs are not checked
    std::unique_ptr<Decided> decided_ = std::make_unique<Decided>();
};

}  // namespace noonmark
