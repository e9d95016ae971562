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
    /// Memory limit for cached rasters; a study that needs more is refused.
    std::uint64_t memoryBytes = std::uint64_t{1} << 30U;
    bool operator==(const ShadowCacheSettings&) const = default;
};

/// A study of one day or a few with projected shadows (projected_shadows.h: the same cities and receivers,
/// the same bits) in a city that is edited. A building that is added, removed or moved costs its own
/// polygons, and minutes are counted again only where a cell's shadow changed.
///
/// For every step it caches how many buildings shade each cell, bit by bit (cached_band.h). Rasters of
/// the shaded cells alone would not suffice: when a building is removed, they do not show whether it was the
/// only one that shaded a cell. Costs about twice the time of one field by projected shadows, and 1 bit per
/// cell and step, times two to four in a dense city: 29 MB to 120 MB for 800 x 800 cells and 360 steps.
///
/// Not thread-safe; uses all cores. Returns cancelled() within 0.2 s of a stop request; the cached data is
/// then lost and rebuilt by the next call.
class ShadowCache {
public:
    /// Error: terrain, receivers on roofs, or more memory needed than the settings allow.
    static Result<ShadowCache> make(const City& city, const Receivers& receivers, const SunSteps& sun,
                                    Progress& progress, const std::stop_token& stop,
                                    ShadowCacheSettings settings = {});
    ShadowCache(ShadowCache&&) noexcept;
    ShadowCache& operator=(ShadowCache&&) noexcept;
    ~ShadowCache();

    /// Changes to another city. `receivers`: on the same grid and region. Buildings that the cities share by
    /// address are unchanged. Errors as of make(), or another region; then nothing has changed.
    Result<void> change(const City& city, const Receivers& receivers, Progress& progress,
                        const std::stop_token& stop);

    /// The field of the current city, bit for bit that of a new run. After an error of change() it is
    /// unchanged; after a cancelled change() it must not be used.
    [[nodiscard]] const ShadowField& field() const;

    [[nodiscard]] std::uint64_t bytes() const;  ///< of the rasters

private:
    struct State;
    explicit ShadowCache(std::unique_ptr<State> cached);
    std::unique_ptr<State> state_;
};

}  // namespace noonmark
