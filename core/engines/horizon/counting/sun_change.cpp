#include "core/engines/horizon/counting/sun_change.h"

#include <algorithm>
#include <iterator>

namespace noonmark {

namespace {

std::vector<HorizonCode> lacking(std::span<const HorizonCode> from, std::span<const HorizonCode> to) {
    std::vector<HorizonCode> missing;
    std::ranges::set_difference(from, to, std::back_inserter(missing));
    return missing;
}

std::span<const HorizonCode> some(const std::vector<HorizonCode>& suns, std::size_t turn) {
    const std::size_t first = std::min(suns.size(), turn * CountChange::maxSuns);
    return std::span(suns).subspan(first, std::min(suns.size() - first, CountChange::maxSuns));
}

}  // namespace

CountChange::CountChange(std::span<const HorizonCode> added, std::span<const HorizonCode> removed) {
    int low = steepnessLevels, high = -steepnessLevels;
    for (const auto& suns : {added, removed})
        if (!suns.empty()) {
            low = std::min(low, int(suns.front()));
            high = std::max(high, int(suns.back()));
        }
    if (low <= high) {
        lowest_ = low;
        last_ = high - low + 1;
    }
    counts_.resize(std::size_t(last_) + 2);
    fill(added, removed);
}

// Fills the counts range by range, between one sun and the next.
void CountChange::fill(std::span<const HorizonCode> added, std::span<const HorizonCode> removed) {
    std::int16_t count = 0;
    auto from = counts_.begin();
    for (auto a = added.begin(), b = removed.begin(); a != added.end() || b != removed.end();) {
        const bool isAdded = b == removed.end() || (a != added.end() && *a < *b);
        const auto to = counts_.begin() + ((isAdded ? *a++ : *b++) - lowest_ + 1);
        std::fill(from, to, count);
        from = to;
        count = std::int16_t(count + (isAdded ? 1 : -1));
        maximum_ = std::max(maximum_, std::abs(int(count)));
    }
    std::fill(from, counts_.end(), count);
}

std::uint16_t CountChange::addDifference(const HorizonCode* before, const HorizonCode* after,
                                         const ReceiverBlocks::Masks& masks, std::uint32_t* sums) const {
    return addDifferences({counts_.data(), lowest_, last_}, before, after, masks, sums);
}

void CountChange::addTo(const HorizonCode* horizons, std::size_t count, std::int16_t* sums) const {
    addCounts({counts_.data(), lowest_, last_}, horizons, count, sums);
}

std::vector<CountChange> findSunChanges(std::span<const HorizonCode> suns,
                                        std::span<const HorizonCode> before) {
    const std::vector<HorizonCode> added = lacking(suns, before), removed = lacking(before, suns);
    std::vector<CountChange> changes;
    for (std::size_t turn = 0; turn * CountChange::maxSuns < std::max(added.size(), removed.size()); ++turn)
        changes.emplace_back(some(added, turn), some(removed, turn));
    return changes;
}

}  // namespace noonmark
