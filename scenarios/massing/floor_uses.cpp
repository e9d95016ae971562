#include "scenarios/massing/floor_uses.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/describe/field_checks.h"
#include "scenarios/massing/massing_fields.h"

namespace noonmark {

namespace {

constexpr std::size_t longestUse = 60;

Result<void> checkUse(const FloorUse& use, bool last) {
    if (use.use.empty() || use.use.size() > longestUse)
        return failure("A use of storeys has no name, or a very long one", "uses",
                       fmt::format("Give 1 to {} letters, such as offices", longestUse));
    if (auto sound = checkRanges(floorUseFields().of(use)); !sound) return sound;
    if (use.storeys > 0 || last) return {};
    return failure(fmt::format("{} takes all storeys above, and other uses follow", use.use), "uses",
                   "Give its number of storeys, or make it the last use");
}

}  // namespace

Result<void> checkUses(const std::vector<FloorUse>& uses) {
    for (const FloorUse& use : uses)
        if (const auto sound = checkUse(use, &use == &uses.back()); !sound) return sound;
    return {};
}

std::vector<UseArea> sumByUse(const std::vector<FloorUse>& uses, std::span<const double> storeyM2) {
    if (uses.empty()) return {};
    std::vector<UseArea> areas;
    const auto take = [&](const std::string& use, std::size_t storeys) {
        const auto some = storeyM2.first(std::min(storeys, storeyM2.size()));
        areas.push_back({use, int(some.size()), std::accumulate(some.begin(), some.end(), 0.0)});
        storeyM2 = storeyM2.subspan(some.size());
    };
    for (const FloorUse& use : uses)
        take(use.use, use.storeys == 0 ? storeyM2.size() : std::size_t(use.storeys));
    if (!storeyM2.empty()) take({}, storeyM2.size());
    return areas;
}

}  // namespace noonmark
