#pragma once

// The folder core/lab/bench/contests runs engines against each other. A Contestant is an engine with
// settings; a contest checks each against the ray reference and then times it in rounds (both in this file).
// moments.h has the statistics of the times, site.h says where and when. contest_runs.cpp and
// core/lab/bench/paper run contests over periods, resolutions and random positions. Allowance
// (core/lab/bench/work.h), Deadline and Forecast (this file) limit the time; contest_runs.cpp predicts the
// time of longer periods. ray_masks.h traces directions that belong to no period.

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/base/progress.h"
#include "core/engines/api/engine_registry.h"
#include "core/engines/api/shadow_field.h"
#include "core/lab/bench/contests/site.h"
#include "core/lab/bench/work.h"
#include "core/receivers/receivers.h"

namespace noonmark::bench {

/// An engine with its settings, ready to run.
struct Contestant {
    std::string engine;   ///< key: "iam"
    std::string name;     ///< "Inverse accrual map"
    std::string setting;  ///< settings that differ from the defaults: "levels 2"; may be empty
    std::shared_ptr<const Engine> accumulator;
    bool needed = false;  ///< the report needs its time: it is never stopped early
};

/// "Inverse accrual map, levels 2"
std::string makeTitle(const Contestant& contestant);

/// The contestants.
struct StartList {
    std::vector<Contestant> contestants;
    std::vector<std::string> absent;  ///< engines that cannot run on this machine, and why
};

/// Every engine with its default settings.
StartList listDefaultEngines(const EngineList& engines);

/// Every engine with its default settings, and with each of its options, one at a time, at these multiples of
/// its default (rounded and clamped to the option's range; no setting twice).
StartList listVariedEngines(const EngineList& engines, const std::vector<double>& factors);

/// One engine with one option at the given values, in order; empty if there is no such engine or option.
std::vector<Contestant> listVariants(const EngineList& engines, std::string_view engine,
                                     std::string_view option, const std::vector<double>& values);

/// A stop token that stops when `outer` does, or after `seconds`; without a time limit if `seconds` is
/// infinite or more than a year.
class Deadline {
public:
    Deadline(double seconds, const std::stop_token& outer)
        : relay_(outer, [this] { source_.request_stop(); }) {
        constexpr double yearS = 365.0 * 24 * 3600;
        if (seconds < yearS)
            timer_ = std::jthread([this, seconds](const auto& done) { wait(done, seconds); });
    }
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

    [[nodiscard]] std::stop_token token() const { return source_.get_token(); }
    /// Stops immediately; may be called from any thread.
    void giveUp() { source_.request_stop(); }

private:
    void wait(const std::stop_token& done, double seconds) {
        std::unique_lock lock(mutex_);
        woken_.wait_for(lock, done, std::chrono::duration<double>(seconds), [] { return false; });
        if (!done.stop_requested()) source_.request_stop();
    }

    std::stop_source source_;
    std::stop_callback<std::function<void()>> relay_;
    std::mutex mutex_;
    std::condition_variable_any woken_;
    std::jthread timer_;  // last: must end before the members it uses
};

/// Whether work that has done `fraction` of itself (0 to 1) will clearly miss its limit: by a fifth, judged
/// once a quarter of the limit has passed. Work that reports no progress is never hopeless.
constexpr bool isHopeless(double elapsedS, double fraction, double limitS) {
    return elapsedS > limitS / 4 && fraction > 0 && elapsedS > fraction * 1.2 * limitS;
}

/// Stops work before its deadline if it is hopeless.
class Forecast final : public Progress {
public:
    /// `deadline` must outlive this object.
    Forecast(Deadline& deadline, double limitS) : deadline_(deadline), limitS_(limitS) {}

    void report(double fraction, std::string_view) override {
        if (isHopeless(watch_.seconds(), fraction, limitS_)) deadline_.giveUp();
    }

private:
    Deadline& deadline_;
    double limitS_;
    Stopwatch watch_;
};

/// Error of a field against the truth at the same receivers and steps; percent.
struct FieldError {
    double areaPct = 0;  ///< absolute difference of the shadow areas, % of the receivers' area
    /// Absolute difference of gross shadow, mean over the cells, % of the sunlit time
    double cellMeanPct = 0;
    double cellP99Pct = 0;  ///< 99 of 100 cells differ by less
    double cellMaxPct = 0;
    bool operator==(const FieldError&) const = default;
};

/// Over `receivers`, which may be a sample of those of the fields. O(n log n).
FieldError errorOf(const ShadowField& field, const ShadowField& truth, const Receivers& receivers);

/// The input of the engines.
struct Scene {
    const City& city;
    const Receivers& receivers;
    const SunSteps& sun;
};

/// The reference that results are compared with, at all receivers or at a sample of them.
struct Truth {
    ShadowField field;
    Receivers receivers;
};

/// The result of one contestant.
struct Placing {
    FieldError error;
    double medianS = 0;      ///< wall time from city to field, seconds
    int runs = 0;            ///< number of runs in the median; 0: not timed
    std::string refusal;     ///< why there is no result, or none that may be timed; empty if there is one
    bool estimated = false;  ///< the time was extrapolated from a part of the receivers or of the days
    /// The reason for the refusal: it was stopped after Extent::neverAboveS, or left out
    bool tooSlow = false;
    std::optional<std::uint64_t> peakBytes{};  ///< of the run that was checked (bench_report.h)
    [[nodiscard]] bool timed() const { return runs > 0; }
};

/// Total time of the check and the runs, seconds; infinite if the contestant was too slow.
double measureCost(const Placing& placing);

/// A result with a larger error counts as wrong and is not timed: percent of the period, mean over the cells.
constexpr double wrongAbovePct = 5;

/// Each contestant runs once and is compared with the truth; those that pass then run in turn, round after
/// round. Extent::runs, onceAboveS and neverAboveS apply, except that neverAboveS does not apply to needed
/// contestants. An engine that refuses the scene takes no part; cancelled() is an error. Returns placings in
/// the order of the contestants.
Result<std::vector<Placing>> runContest(const Scene& scene, std::span<const Contestant> contestants,
                                        const Truth& truth, const Extent& extent, const Work& work);

/// Runs only those contestants that fit into `seconds` together, the cheapest first; the others are left out.
/// `costs`: expected seconds of each.
Result<std::vector<Placing>> runContestWithin(double seconds, const std::vector<double>& costs,
                                              const Scene& scene, std::span<const Contestant> contestants,
                                              const Truth& truth, const Extent& extent, const Work& work);

/// The result of the ray reference.
Result<Truth> computeTruth(const Scene& scene, const Receivers& receivers, const Work& work);

/// The ray reference's time for all of `receivers`, extrapolated from `truth` of a sample: its stage "trace"
/// is proportional to them, its other stages do not change.
double secondsForAll(const Truth& truth, const Receivers& receivers);

/// Name of the inverse accrual map's setting without the direction graph: every hour of every day is
/// computed.
inline constexpr const char* withoutGraph = "no graph";

/// The contest of all engines and settings over one period, in the middle of the city.
struct PeriodRun {
    std::string name;  ///< "a day"; empty if only the number of days matters
    int days = 1;
    double hours = 6;  ///< per day
    std::vector<Contestant> contestants;
    std::vector<Placing> placings;  ///< in the order of the contestants
};

/// Runs contests over the hour from noon, then over Extent::dayCounts days of 6 h from 9:00; the first day is
/// the site's date. The hour and the periods of 1, 30 and 365 days have a name and run every setting; the
/// other periods run the default settings, and the inverse accrual map without its direction graph.
///
/// Over more than a day the truth is a sample of receivers, and the ray reference's time is extrapolated from
/// it. A contestant that was too slow over one period, or is predicted to be, is left out of longer ones.
/// Settings other than the defaults run after those, as many as fit into the allowance, in each period
/// those of the fastest engines first.
Result<std::vector<PeriodRun>> benchPeriods(const BenchSite& site, const Extent& extent,
                                            const EngineList& engines, const Work& work);

/// The contest of all engines at one resolution of the square in the middle of the city.
struct ResolutionRun {
    int cellsASide = 0;
    std::vector<Placing> placings;  ///< in the order of the engines
};

/// Runs the hour from noon of the site's date at each of Extent::resolutions, coarsest first. All engines run
/// at the first two; at finer ones as many as time allows. Error if no resolution is possible.
Result<std::vector<ResolutionRun>> benchResolutions(const BenchSite& site, const Extent& extent,
                                                    const StartList& engines, const Work& work);

/// For pages: " at 1024" if the finest resolution measured is not the finest requested; else nothing.
std::string describeResolutionIfCoarser(int finest, double cellsASide);

}  // namespace noonmark::bench
