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

/// Traces the rays of RayReference for longest runs that horizons leave in doubt (run_doubts.h).
class RunRays {
public:
    /// `city`, `receivers` and `sun` must outlive it. `used`: indices of the buildings in reach. Error if
    /// memory runs out; cancelled().
    static Result<RunRays> over(const City& city, std::span<const std::uint32_t> used,
                                const Receivers& receivers, const SunSteps& sun, bool checksRuns,
                                const std::stop_token& stop);

    /// The rays of one receiver. With `checksRuns` they include findLit. A gap narrower than a bin may be
    /// seen by no bin; if it contains several steps of a day, it is met on every day, whereas steps that are
    /// farther apart skip it on some day.
    [[nodiscard]] RunSearch::Rays of(std::uint32_t cell);

    /// Whether of() provides findLit.
    [[nodiscard]] bool checkRuns() const { return !packets_.empty(); }

    void countReceiver() { ++decided_->receivers; }
    [[nodiscard]] std::uint64_t receivers() const { return decided_->receivers; }  ///< decided by rays
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
    std::vector<SunPacket> packets_;  // empty if runs are not checked
    std::unique_ptr<Decided> decided_ = std::make_unique<Decided>();
};

}  // namespace noonmark
