#include <algorithm>

#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

namespace {

/// Less is rounding.
constexpr double noChangeMin = 1e-3;

SunChange changeOf(const SunOfPlace& before, const SunOfPlace& after, double lossMin) {
    if (before.ofCells.empty()) return {};
    SunChange change{after.meanHours - before.meanHours, 0, 0, 0};
    const bool anyInside = std::ranges::any_of(before.ofCells, &SunOfCell::isInside);
    double all = 0, lost = 0;
    for (std::size_t i = 0; i < before.ofCells.size(); ++i) {
        const SunOfCell& cell = before.ofCells[i];
        const double gainMin = 60 * (double(after.ofCells[i].hours) - double(cell.hours));
        all += double(cell.share);
        if (-gainMin > lossMin + noChangeMin) lost += double(cell.share);
        if (anyInside && !cell.isInside) continue;
        if (gainMin < -noChangeMin) change.maxLossMin = std::max(change.maxLossMin, -gainMin);
        if (gainMin > noChangeMin) change.maxGainMin = std::max(change.maxGainMin, gainMin);
    }
    change.lostShare = lost / all;
    return change;
}

}  // namespace

// Cells hold float hours: compared with 4.1 as float, 4.1 is enough.
double computeEnoughShare(const SunOfPlace& of, double hours) {
    double all = 0, enough = 0;
    for (const SunOfCell& cell : of.ofCells) {
        all += double(cell.share);
        if (cell.hours >= float(hours)) enough += double(cell.share);
    }
    return enough / all;
}

std::vector<SunChange> computeChanges(const SunByPlace& before, const SunByPlace& after) {
    std::vector<SunChange> changes;
    for (std::size_t i = 0; i < before.sun.size(); ++i)
        changes.push_back(changeOf(before.sun[i], after.sun[i], before.settings.lossMin));
    return changes;
}

}  // namespace noonmark
