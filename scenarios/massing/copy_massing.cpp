#include "scenarios/massing/copy_massing.h"

#include <algorithm>
#include <utility>

namespace noonmark {

namespace {

double statedArea(const PlateSize& size, double lotM2) {
    return size.areaM2.value_or(size.shareOfLot.value_or(1) * lotM2);
}

// The same area, or as much as there is room for; the plate of a whole lot stays one.
PlateSize fitSize(double wantedM2, double roomM2, bool wholeLot, bool& reduced) {
    if (wholeLot) return {.shareOfLot = 1};
    reduced = reduced || wantedM2 > roomM2;
    return {.areaM2 = std::min(wantedM2, roomM2)};
}

bool coversLot(const PlateSize& size, double lotM2) { return statedArea(size, lotM2) >= lotM2 * (1 - 1e-9); }

CopiedMassing fitPlates(double fromM2, const MassingSettings& settings, double toM2) {
    CopiedMassing copy{.settings = settings};
    double roomM2 = toM2;
    if (settings.podium) {
        const PlateSize& plate = settings.podium->plate;
        copy.settings.podium->plate =
            fitSize(statedArea(plate, fromM2), toM2, coversLot(plate, fromM2), copy.plateReduced);
        roomM2 = statedArea(copy.settings.podium->plate, toM2);
    }
    const bool whole = !settings.podium && coversLot(settings.plate, fromM2);
    copy.settings.plate = fitSize(statedArea(settings.plate, fromM2), roomM2, whole, copy.plateReduced);
    return copy;
}

// Straightens all volumes; false if none is twisted.
bool dropTwists(MassingSettings& settings) {
    bool any = std::exchange(settings.walls.twistDeg, 0) != 0;
    if (settings.podium) any = std::exchange(settings.podium->walls.twistDeg, 0) != 0 || any;
    for (Setback& setback : settings.setbacks) any = std::exchange(setback.walls.twistDeg, 0) != 0 || any;
    return any;
}

}  // namespace

Result<CopiedMassing> copyMassing(const Footprint& from, const MassingSettings& settings,
                                  const Footprint& to) {
    CopiedMassing copy = fitPlates(area(from), settings, area(to));
    while (true) {
        const auto made = makeMassing(to, copy.settings);
        if (made) return copy;
        if (copy.settings.clockwiseDeg != 0) {
            copy.settings.clockwiseDeg = 0;
            copy.turnDropped = true;
        } else if (dropTwists(copy.settings)) {
            copy.twistDropped = true;
        } else if (!copy.settings.setbacks.empty()) {
            copy.settings.setbacks.pop_back();
            ++copy.setbacksDropped;
        } else {
            return tl::make_unexpected(made.error());
        }
    }
}

}  // namespace noonmark
