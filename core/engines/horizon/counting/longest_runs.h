#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/common/open_below.h"
#include "core/engines/common/sun_packets.h"
#include "core/engines/horizon/counting/walk_steps.h"
#include "core/engines/ray/ray_scene.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Searches the longest run of one receiver if horizons leave some steps in doubt. Traces as few rays as
/// possible, and looks at few of the steps that are certainly lit. In a run that would be the longest if all
/// its doubtful steps were hidden, it first tests the steps in bins where another day was found lit, then
/// those that the bin's own horizon does not hide, then all; of each the ones closest to the middle first,
/// since light there leaves two runs too short to matter. Reuses its memory; one per thread.
class RunSearch {
public:
    /// Ray queries for the receiver; steps are indices in the period.
    struct Rays {
        std::function<bool(std::uint32_t step)> hidden;
        /// A lit step in [first, end), if any; null: steps that are certainly hidden according to the
        /// horizons are not tested.
        std::function<std::optional<std::uint32_t>(std::uint32_t first, std::uint32_t end)> findLit;
    };
    /// The horizons of the receiver, one code per bin: a step is certainly lit if the highest code of its bin
    /// does not hide it, certainly hidden if the lowest does, and in doubt probably what its own code says.
    struct Horizons {
        std::vector<HorizonCode> highest, own, lowest;
    };

    /// To be filled before begin().
    [[nodiscard]] Horizons& horizons() { return horizons_; }
    /// Selects a receiver whose longest run is known to have at least `atLeast` steps. `steps`: of the
    /// period.
    void begin(Rays rays, std::span<const TimedStep> steps, int atLeast);
    void walk(const DaySteps& day);
    [[nodiscard]] int longest() const { return int(longest_); }

private:
    /// A step whose horizons neither hide it nor show it for certain.
    struct Doubt {
        std::uint32_t step;
        std::uint16_t bin;
        bool isProbablyLit;
        bool isHidden = false;  ///< a ray found it hidden
    };
    /// Which doubts to look at.
    enum class Which { inLitBins, probablyLit, all };
    [[nodiscard]] bool isWanted(const Doubt& doubt, Which which) const;
    [[nodiscard]] bool mayBeHidden(std::uint32_t step) const {
        const StepPlace& place = steps_[step].place;
        return horizons_.highest[place.bin] > place.sun;
    }
    void findDoubts(std::uint32_t first, std::uint32_t end);
    void search(std::uint32_t first, std::uint32_t end);
    [[nodiscard]] std::optional<std::uint32_t> litIn(std::uint32_t first, std::uint32_t end);
    [[nodiscard]] std::optional<std::uint32_t> litFromMiddle(std::span<Doubt> doubts, std::uint32_t middle,
                                                             Which which);
    void noteLit(std::uint32_t step);

    Horizons horizons_;
    Rays rays_;
    std::span<const TimedStep> steps_;
    std::vector<Doubt> doubts_;           // of the run that is searched, ascending
    std::vector<std::uint8_t> isLitBin_;  // for each bin, whether a step was found lit
    bool foundLit_ = false;               // whether there is such a bin
    std::uint32_t longest_ = 0;
};

/// Traces the rays of RayReference for longest runs that horizons leave in doubt (run_decider.h).
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

/// Steps [first, end) of the period, all of one day.
struct StepRun {
    std::uint32_t first = 0, end = 0;
    [[nodiscard]] int length() const { return int(end - first); }
};

/// Finds the longest unbroken runs in shadow over a period, day by day: 64 receivers walk every step
/// together, in less time than it takes to find out which days need not be walked.
class LongestRuns {
public:
    /// No day may have more than 32,767 steps.
    explicit LongestRuns(std::vector<TimedStep> steps) : steps_(std::move(steps)), days_(findDays(steps_)) {}

    /// The longest run of each receiver and the day on which it was found, as an index for run().
    struct Found {
        RunLanes longest;
        std::array<std::uint32_t, lanesPerPart> day{};
    };
    /// Longest runs, in steps. `horizons`: one entry per bin. 1 ns a step.
    [[nodiscard]] Found of(std::span<const RunLanes> horizons) const;

    /// The run of `length` steps of a lane on a day, as found by of().
    [[nodiscard]] StepRun run(std::span<const RunLanes> horizons, std::size_t lane, std::uint32_t day,
                              int length) const;

    /// The longest run of each lane on each day, in steps.
    void ofEachDay(std::span<const RunLanes> horizons, std::vector<RunLanes>& longest) const;

    /// The longest run of one lane, in steps, as found by `search`, which must have been begun with its
    /// horizons. `maximum`: upper bounds, from ofEachDay(); days that cannot contain the longest run are
    /// skipped.
    [[nodiscard]] int searched(std::size_t lane, std::span<const RunLanes> maximum, RunSearch& search) const;

    /// The longest run of one receiver, step by step; `hidden(place)` states whether a step is in shadow.
    template <class Hidden>
    [[nodiscard]] StepRun ofOne(const Hidden& hidden) const {
        StepRun run, longest;
        for (std::uint32_t step = 0; step < steps_.size(); ++step) {
            const bool isHidden = hidden(steps_[step].place);
            if (!isHidden || steps_[step].startsRun) run.first = isHidden ? step : step + 1;
            run.end = step + 1;
            if (run.length() > longest.length()) longest = run;
        }
        return longest;
    }

    [[nodiscard]] std::span<const TimedStep> steps() const { return steps_; }

private:
    void walk(std::span<const RunLanes> horizons, const DaySteps& day, RunLanes& longest) const {
        walkSteps(horizons, steps().subspan(day.first, day.end - day.first), longest);
    }

    std::vector<TimedStep> steps_;
    std::vector<DaySteps> days_;
};

}  // namespace noonmark
