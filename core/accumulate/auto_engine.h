#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/accumulate/accumulator.h"

namespace noonmark {

/// Seconds that engines are expected to take on two cores: to compare them with each other, no more. Worked
/// out from a dense city (the grid sample); other machines differ alike.
struct ExpectedSeconds {
    double ray = 0;        ///< receivers x steps x 10 ns
    double projected = 0;  ///< steps x (buildings in reach x 0.2 us + rows x 0.5 us)
    double horizon = 0;    ///< bins x (receivers x 5 ns + buildings in reach x 0.05 us), and 3 ps for each
                           ///< receiver and step; where receivers have heights of their own 40 ns instead of
                           ///< 5, and bins x terrain cells x 10 ns
};
ExpectedSeconds expectedSeconds(const Receivers& receivers, std::size_t buildingsInReach, const SunSteps& sun,
                                double binDeg, std::size_t terrainCells = 0);

/// An engine that was chosen, and why.
struct EngineChoice {
    std::string_view key;  ///< of coreEngines()
    std::unique_ptr<Accumulator> engine;
    std::string why;  ///< "rays, since there is terrain"

    /// The engine's field, which says that it was chosen and why.
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const;
};

/// The ray reference, where the chosen engine refused: it takes every case.
EngineChoice raysSince(const EngineChoice& refused, const Error& error);

/// Chooses the engine and says in the field's `engine` which one and why. On flat ground projected shadows,
/// which are exact, where they are expected to take no longer than the horizon sweep or no more than 2 s; on
/// terrain and roofs the ray reference on the same terms; else the horizon sweep, whose cells are off by 0.04
/// % of a long period in the mean. Where the one chosen refuses the case the ray reference takes it.
class AutoEngine final : public Accumulator {
public:
    explicit AutoEngine(double binDeg) : binDeg_(binDeg) {}
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const override;

    /// One engine for fields that are to be compared with each other, by the city that costs most: fields of
    /// two engines would differ where the cities do not.
    [[nodiscard]] EngineChoice choose(std::span<const City* const> cities, const Receivers& receivers,
                                      const SunSteps& sun) const;

private:
    double binDeg_;
};

}  // namespace noonmark
