#pragma once

#include <cstdint>
#include <memory>

#include "core/engines/api/shadow_counts.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark {

struct HorizonCacheSettings {
    double binDeg = 0.5;  ///< width of an azimuth bin, degrees, 0.1 to 2
    /// For horizons that stay: 2 bytes for each cell of the region's box and bin, 8 for each interval that a
    /// part which hangs hides there, and another 2 where the buildings that came last raise horizons. Of a
    /// larger region some tiles are swept anew each time.
    std::uint64_t memoryBytes = std::uint64_t{1} << 30U;
    bool operator==(const HorizonCacheSettings&) const = default;
};

/// A study by horizons that stay: other dates, hours, steps and weights are a walk through tables, and a city
/// that changed by a few buildings is looked at only where these stand, stood or throw their shadow. A city
/// and receivers as the horizon sweep takes them (horizon_sweep.h: terrain, roofs and parts that hang, too),
/// with the same error; but each bin's suns are taken in its middle whatever the period, so that short
/// periods are less exact there, and no rays decide longest runs.
///
/// Rounding: a horizon is kept as its level of 65,535, rounded down (horizon_code.h), which is what a
/// fresh sweep counts with too. So after any changes the field is that of new HorizonCache of the same city,
/// bit for bit.
///
/// Not for several threads at a time; uses all cores. Stops within 0.2 s with cancelled(): what was kept may
/// then be lost, and the next call sweeps it again.
class HorizonCache {
public:
    /// Sweeps nothing yet. Error: a width out of range.
    static Result<HorizonCache> make(const City& city, const Receivers& receivers,
                                     HorizonCacheSettings settings = {});
    HorizonCache(HorizonCache&&) noexcept;
    HorizonCache& operator=(HorizonCache&&) noexcept;
    ~HorizonCache();

    /// The field of a period; without runs withRuns() gives them later. Sweeps the bins that are not there
    /// yet, or not for suns as low. Cost: a sweep of those; then some 0.3 ns a receiver and bin whose suns
    /// are not those of the period before, and the walk of the longest runs if these are wanted. Error: what
    /// the horizon sweep refuses; of what hangs only that counts which the period's suns may throw into
    /// the region.
    Result<ShadowField> retime(const SunSteps& sun, Progress& progress, std::stop_token stop,
                               ShadowCounts counts = ShadowCounts::grossAndRuns);

    /// The field of the present period in another city. `receivers`: the same grid and region. Buildings that
    /// the cities share by address did not change. Cost: of the shadows that came and went; where what goes
    /// is what came with the change before, as while a building is dragged, nothing is found again. Other
    /// terrain, receivers on roofs where there were none and a lowest receiver in another 64 m of height make
    /// all anew. Error, and nothing changed: no period yet, another grid, or what the horizon sweep refuses.
    Result<ShadowField> change(const City& city, const Receivers& receivers, Progress& progress,
                               std::stop_token stop, ShadowCounts counts = ShadowCounts::grossAndRuns);

    /// The present field with its longest runs: only those are counted that are out of date. Error: no period
    /// yet.
    Result<ShadowField> withRuns(Progress& progress, std::stop_token stop);

    [[nodiscard]] std::uint64_t bytes() const;  ///< of the horizons that are there

private:
    struct State;
    explicit HorizonCache(std::unique_ptr<State> cached);
    std::unique_ptr<State> state_;
};

}  // namespace noonmark
