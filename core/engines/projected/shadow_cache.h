#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/shadow_field.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

struct ShadowCacheSettings {
    /// For rasters that stay; a study that needs more is refused.
    std::uint64_t memoryBytes = std::uint64_t{1} << 30U;
    bool operator==(const ShadowCacheSettings&) const = default;
};

/// The study of one day or a few by projected shadows (projected_shadows.h: the same cities and receivers,
/// the same bits) in a city that is edited: a building that comes, goes or moves costs its own polygons, and
/// minutes are counted again only where a cell's shadow changed.
///
/// At every step it is kept how many buildings shade each cell, bit by bit (building_counts.h): with
/// rasters of what is dark alone nobody could tell, where a building goes, whether it was the only one. Costs
/// some twice the time of one field by projected shadows, and 1 bit a cell and step, times two to four in a
/// dense city: 29 MB to 120 MB for 800 x 800 cells and 360 steps.
///
/// Not for several threads at a time; uses all cores. Stops within 0.2 s with cancelled(): what was kept is
/// then lost, and the next call makes it again.
class ShadowCache {
public:
    /// Error: terrain, receivers on roofs, more memory than the settings allow.
    static Result<ShadowCache> make(const City& city, const Receivers& receivers, const SunSteps& sun,
                                    Progress& progress, const std::stop_token& stop,
                                    ShadowCacheSettings settings = {});
    ShadowCache(ShadowCache&&) noexcept;
    ShadowCache& operator=(ShadowCache&&) noexcept;
    ~ShadowCache();

    /// From now on another city. `receivers`: the same grid and region. Buildings that the cities share by
    /// address did not change. Errors as of make(), or another region: then nothing changed.
    Result<void> change(const City& city, const Receivers& receivers, Progress& progress,
                        const std::stop_token& stop);

    /// Of the present city: bit for bit that of a fresh run. After an error of change() as it was, or, where
    /// that was stopped, not to be used.
    [[nodiscard]] const ShadowField& field() const;

    [[nodiscard]] std::uint64_t bytes() const;  ///< of the rasters

private:
    struct State;
    explicit ShadowCache(std::unique_ptr<State> cached);
    std::unique_ptr<State> state_;
};

}  // namespace noonmark
