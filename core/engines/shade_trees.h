#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/step_sets.h"
#include "core/engines/api/tree_shade.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The city with the trees that these columns count, as engines weigh them; without trees where they count
/// none.
City withTreesFor(City city, TreeColumns columns);

/// Whether `wanted` has this column, evergreen or seasonal.
constexpr bool isAmong(TreeColumns wanted, TreeColumns column) {
    return wanted == TreeColumns::all || wanted == column;
}

/// The field with trees of one column, evergreen or seasonal; the field itself where no tree reaches it.
const ShadowField& fieldOfColumn(const ShadowField& field, TreeColumns column);

/// Seconds that the shade of a city's trees takes on two cores. 0: no tree reaches a receiver.
struct TreeSeconds {
    double rays = 0;   ///< exact
    double sweep = 0;  ///< a horizon sweep
};
/// Within a factor of two; `counts`: what a sweep counts. Some ms.
TreeSeconds estimateTreeSeconds(const City& city, const Receivers& receivers, const SunSteps& sun,
                                ShadowCounts counts);

/// The shade of a city's trees on top of a field of the same city, receivers and steps, by whichever engine:
/// that engine's own (ShadowField::trees) where it weighs crowns, else by rays, or by a horizon sweep of its
/// own where rays take longer than that and more than 2 s (rays again where the sweep refuses). Null where no
/// tree reaches a receiver, and for TreeColumns::without. cancelled() when stopped.
Result<std::shared_ptr<const TreeShade>> shadeTrees(const City& city, const Receivers& receivers,
                                                    const SunSteps& sun, const ShadowField& field,
                                                    TreeColumns columns, Progress& progress,
                                                    const std::stop_token& stop);

struct SweptRuns;

/// Adds the longest runs of a sweep to columns that have those of buildings alone: crowns count where the
/// sweep has longer ones with them than without.
void addRuns(const SweptRuns& runs, const Receivers& receivers, TreeShade& shade);

/// A period's shadow by sets of steps with trees; at least one is there.
struct ShadedSets {
    std::optional<ShadowBreakdown> evergreen;  ///< every tree in leaf all year
    std::optional<ShadowBreakdown> seasonal;   ///< trees bare out of season
    std::size_t treesUsed = 0;                 ///< trees whose shadow can reach a receiver
    std::string how;                           ///< in words, for the report
    [[nodiscard]] const std::optional<ShadowBreakdown>& of(TreeColumns column) const {
        return column == TreeColumns::evergreen ? evergreen : seasonal;
    }
};

/// The same by sets of steps, on top of a breakdown of the same city, receivers and steps by whichever
/// engine: by one horizon sweep for all sets, or by rays to few steps (areRaysQuicker() of crown_sweep.h).
/// None where no tree reaches a receiver, and for TreeColumns::without. cancelled() when stopped.
Result<std::optional<ShadedSets>> shadeTreeSets(const City& city, const Receivers& receivers,
                                                const SunSteps& sun, const ShadowBreakdown& without,
                                                TreeColumns columns, Progress& progress,
                                                const std::stop_token& stop);

}  // namespace noonmark
