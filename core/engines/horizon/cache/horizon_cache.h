#pragma once

// The cache of the horizon sweep, for dragging buildings and trying other hours. HorizonCache is the
// interface. It holds CachedTile objects, each with a CachedBin per azimuth and a TileCount of the current
// period (cached_tile.h). WallCache and OverhangCache hold the occluders and compute what an edit removes
// and adds. tile_edit.h finds the blocks and lists the receivers that an edit changes, and updates their
// horizons and overhang intervals of one azimuth. BaselineCodes keeps the horizons without the buildings
// added last, so that moving these is cheap.

#include <cstdint>
#include <memory>

#include "core/engines/api/shadow_field.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark {

struct HorizonCacheSettings {
    double binDeg = 0.5;  ///< width of an azimuth bin, degrees, 0.1 to 2
    /// Memory limit for cached horizons: 2 bytes per cell of the region's bounding box and bin, 8 per
    /// interval that an overhang hides there, and another 2 per cell where the buildings added by the last
    /// change raise horizons. In regions that exceed the limit, some tiles are swept again each time.
    std::uint64_t memoryBytes = std::uint64_t{1} << 30U;
    bool operator==(const HorizonCacheSettings&) const = default;
};

/// A study with cached horizons. For other dates, hours, steps and weights the cached horizons are only
/// looked up in tables. After an edit of a few buildings, only places at these buildings and in their shadows
/// are examined. Supports the same cities and receivers as the horizon sweep (horizon_sweep.h), including
/// terrain, roofs and overhangs, with the same error; but the suns of a bin are placed at its middle whatever
/// the period, which is less accurate for short periods, and rays do not decide longest runs.
///
/// Rounding: a cached horizon is one of 65,535 levels, rounded down (horizon_code.h), exactly as a new sweep
/// counts it. So after any changes the field equals that of a new HorizonCache of the same city, bit for bit.
///
/// Not thread-safe; uses all cores. Returns cancelled() within 0.2 s of a stop request; cached horizons may
/// then be lost and are swept again by the next call.
class HorizonCache {
public:
    /// Creates an empty cache; nothing is swept yet. Error if the width is out of range.
    static Result<HorizonCache> make(const City& city, const Receivers& receivers,
                                     HorizonCacheSettings settings = {});
    HorizonCache(HorizonCache&&) noexcept;
    HorizonCache& operator=(HorizonCache&&) noexcept;
    ~HorizonCache();

    /// The field of a period; without runs, withRuns() can add them later. Sweeps the bins that are not
    /// cached or not for suns as low as needed. Cost: the sweep of these bins, then some 0.3 ns per receiver
    /// and bin whose suns differ from the previous period, and the search for longest runs if wanted. Error:
    /// whatever the horizon sweep refuses; the limit on overhangs applies to those from which the period's
    /// suns may cast shadow into the region.
    Result<ShadowField> computePeriod(const SunSteps& sun, Progress& progress, std::stop_token stop,
                                      ShadowCounts counts = ShadowCounts::grossAndRuns);

    /// The field of the current period in another city. `receivers`: on the same grid and region. Buildings
    /// that the cities share by address are unchanged. Cost: proportional to the removed and added shadows.
    /// If the removed buildings are those that the previous change added, as while a building is dragged, no
    /// horizon is recomputed. Different terrain, receivers on roofs where there were none before, or a lowest
    /// receiver in another 64 m step of height rebuild the whole cache. Error, with no change made: no period
    /// yet, another grid, or whatever the horizon sweep refuses.
    Result<ShadowField> change(const City& city, const Receivers& receivers, Progress& progress,
                               std::stop_token stop, ShadowCounts counts = ShadowCounts::grossAndRuns);

    /// The current field with longest runs; only those that are out of date are counted. Error: no period
    /// yet.
    Result<ShadowField> withRuns(Progress& progress, std::stop_token stop);

    [[nodiscard]] std::uint64_t bytes() const;  ///< memory used by cached horizons

private:
    struct State;
    explicit HorizonCache(std::unique_ptr<State> cached);
    std::unique_ptr<State> state_;
};

}  // namespace noonmark
