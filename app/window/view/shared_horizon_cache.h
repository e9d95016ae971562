#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <stop_token>

#include "core/engines/horizon/cache/horizon_cache.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// When shadow is looked at, and where the sun is seen from.
struct SunQuestion {
    Period period;
    Observer observer;
    bool operator==(const SunQuestion&) const = default;
};

/// Horizons that stay for the whole window: one set, of the grid and ground that were asked about last, with
/// whatever buildings and period. The time sliders and the live shadow of what is shaped ask it from jobs of
/// their own: one waits for the other.
class SharedHorizonCache {
public:
    /// For all horizons that stay: 800 x 800 cells take 0.6 GiB of it for the suns of a year.
    static constexpr std::uint64_t memoryBytes = std::uint64_t{1} << 30U;
    static constexpr double binDeg = 0.5;

    /// What it costs is what differs from the question before: nothing is swept anew but for another grid or
    /// ground, for lower suns and around buildings that changed. Errors: those of HorizonCache, a sun that is
    /// never there, cancelled(). After any of them the next question is answered as if it were the first one.
    Result<ShadowField> field(const City& city, const Receivers& receivers, const SunQuestion& question,
                              ShadowCounts counts, Progress& progress, const std::stop_token& stop);

    void forget();  ///< frees the memory; waits for an answer that is being worked out
    /// How many sets were begun so far.
    [[nodiscard]] int sets() const { return sets_; }

private:
    /// What the horizons are of.
    struct State {
        HorizonCache horizons;
        Grid grid;
        bool flat = true;    ///< of the receivers
        bool known = false;  ///< the city and the cells below are those of the horizons
        City city{};
        std::vector<CellKind> kind{};
    };
    Result<void> setSun(const SunQuestion& question, const std::stop_token& stop);
    Result<void> setGrid(const City& city, const Receivers& receivers);
    Result<ShadowField> counted(const City& city, const Receivers& receivers, ShadowCounts counts,
                                Progress& progress, const std::stop_token& stop);
    void note(const City& city, const Receivers& receivers, const Result<ShadowField>& field);

    std::timed_mutex mutex_;
    std::optional<State> state_;
    std::optional<SunQuestion> question_;  // whose steps these are
    SunSteps sun_;
    bool counted_ = false;  // the horizons' period is that one
    std::atomic<int> sets_ = 0;
};

}  // namespace noonmark
