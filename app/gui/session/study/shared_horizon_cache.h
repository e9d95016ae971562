#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <stop_token>

#include "core/engines/horizon/cache/horizon_cache.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The period, and the place from which the sun is seen.
struct SunQuestion {
    Period period;
    Observer observer;
    bool operator==(const SunQuestion&) const = default;
};

/// Horizons cached for the whole window: one set, for the grid and ground used last, with any buildings and
/// period. The time sliders and the live shadow use it from their own jobs; one waits for the other.
class SharedHorizonCache {
public:
    /// Limit for the cached horizons: 800 x 800 cells take 0.6 GiB of it for the sun positions of a year.
    static constexpr std::uint64_t memoryBytes = std::uint64_t{1} << 30U;
    static constexpr double binDeg = 0.5;

    /// The cost depends on what differs from the previous call: horizons are swept again only for another
    /// grid or ground, for lower suns and around changed buildings. Errors: those of HorizonCache, a sun that
    /// never rises, cancelled(). After an error the next call works as if it were the first.
    Result<ShadowField> field(const City& city, const Receivers& receivers, const SunQuestion& question,
                              ShadowCounts counts, Progress& progress, const std::stop_token& stop);

    void forget();  ///< frees the memory; waits for a running call
    /// Number of sets begun so far.
    [[nodiscard]] int sets() const { return sets_; }

private:
    /// The horizons and what they were computed for.
    struct State {
        HorizonCache horizons;
        Grid grid;
        bool flat = true;    ///< whether the receivers are on level ground
        bool known = false;  ///< the horizons match city and kind below
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
    std::optional<SunQuestion> question_;  // the question of sun_
    SunSteps sun_;
    bool counted_ = false;  // the horizons were counted for question_
    std::atomic<int> sets_ = 0;
};

}  // namespace noonmark
