#include "scenarios/massing/nearest_fit.h"

#include <cmath>
#include <vector>

namespace noonmark {

namespace {

// Settings whose numbers are all stated: the height, and plates as areas.
struct StatedMassing {
    MassingSettings settings;
    double podiumStoreys = 0;

    StatedMassing(const MassingSettings& given, double lotM2) : settings(given) {
        settings.heightM = heightOf(given);
        settings.storeys = 0;
        statePlate(settings.plate, lotM2);
        if (!settings.podium) return;
        statePlate(settings.podium->plate, lotM2);
        podiumStoreys = settings.podium->storeys;
    }

    static void statePlate(PlateSize& plate, double lotM2) {
        plate = {.areaM2 = plate.areaM2.value_or(plate.shareOfLot.value_or(1) * lotM2)};
    }

    [[nodiscard]] MassingSettings take() const {
        MassingSettings made = settings;
        if (made.podium) made.podium->storeys = int(std::lround(podiumStoreys));
        return made;
    }
};

struct Slot {
    MassingNumber number;
    double* value;
    double step;
    std::size_t setback = 0;
};

constexpr double metreStep = 0.1, shareStep = 0.01, degreeStep = 1, areaStepM2 = 1, storeyStep = 1;

std::vector<Slot> listSlots(StatedMassing& massing) {
    MassingSettings& tower = massing.settings;
    std::vector<Slot> slots{{MassingNumber::height, &tower.heightM, metreStep},
                            {MassingNumber::storeyHeight, &tower.storeyHeightM, metreStep},
                            {MassingNumber::turn, &tower.clockwiseDeg, degreeStep},
                            {MassingNumber::plate, &*tower.plate.areaM2, areaStepM2},
                            {MassingNumber::taper, &tower.walls.taper, shareStep},
                            {MassingNumber::twist, &tower.walls.twistDeg, degreeStep}};
    if (tower.podium) {
        slots.push_back({MassingNumber::podiumStoreys, &massing.podiumStoreys, storeyStep});
        slots.push_back({MassingNumber::podiumPlate, &*tower.podium->plate.areaM2, areaStepM2});
        slots.push_back({MassingNumber::podiumTaper, &tower.podium->walls.taper, shareStep});
        slots.push_back({MassingNumber::podiumTwist, &tower.podium->walls.twistDeg, degreeStep});
    }
    for (std::size_t i = 0; i < tower.setbacks.size(); ++i) {
        Setback& setback = tower.setbacks[i];
        slots.push_back({MassingNumber::setbackAbove, &setback.aboveM, metreStep, i});
        slots.push_back({MassingNumber::setbackInset, &setback.insetM, metreStep, i});
        slots.push_back({MassingNumber::setbackTaper, &setback.walls.taper, shareStep, i});
        slots.push_back({MassingNumber::setbackTwist, &setback.walls.twistDeg, degreeStep, i});
    }
    return slots;
}

// None where no number differs, or several do.
std::optional<std::size_t> findDifference(const std::vector<Slot>& one, const std::vector<Slot>& other) {
    std::optional<std::size_t> difference;
    if (one.size() != other.size()) return std::nullopt;
    for (std::size_t i = 0; i < one.size(); ++i) {
        if (std::abs(*one[i].value - *other[i].value) < 1e-9) continue;
        if (difference) return std::nullopt;
        difference = i;
    }
    return difference;
}

// Towards the value that is possible.
double roundTowards(double possible, double value, double step) {
    const double steps = value / step;
    return (possible < value ? std::floor(steps + 1e-9) : std::ceil(steps - 1e-9)) * step;
}

// Plates and heights in the form in which the user stated them.
MassingSettings restate(const MassingSettings& fit, const MassingSettings& wanted, double lotM2) {
    MassingSettings settings = withHeight(fit, fit.heightM);
    const auto plateAs = [lotM2](PlateSize& plate, const PlateSize& stated) {
        if (stated.areaM2) return;
        const double share = std::floor(*plate.areaM2 / lotM2 * 100 + 1e-9) / 100;
        plate = stated.shareOfLot || share < 1 ? PlateSize{.shareOfLot = share} : PlateSize{};
    };
    plateAs(settings.plate, wanted.plate);
    if (settings.podium && wanted.podium) plateAs(settings.podium->plate, wanted.podium->plate);
    return settings;
}

}  // namespace

std::optional<NearestFit> findNearestFit(const Footprint& lot, const MassingSettings& possible,
                                         const MassingSettings& wanted) {
    const double lotM2 = area(lot);
    StatedMassing from(possible, lotM2), to(wanted, lotM2);
    const std::vector<Slot> good = listSlots(from), bad = listSlots(to);
    const auto differs = findDifference(good, bad);
    if (!differs) return std::nullopt;
    const Slot& slot = bad[*differs];
    const double goodValue = *good[*differs].value, wantedValue = *slot.value;
    const double step =
        slot.number == MassingNumber::height && wanted.storeys > 0 ? wanted.storeyHeightM : slot.step;
    const auto fits = [&](double value) {
        *slot.value = value;
        return makeMassing(lot, restate(to.take(), wanted, lotM2)).has_value();
    };
    double nearest = goodValue, tooFar = wantedValue;
    while (std::abs(tooFar - nearest) > step / 4) {
        const double value = (nearest + tooFar) / 2;
        (fits(value) ? nearest : tooFar) = value;
    }
    nearest = roundTowards(goodValue, nearest, step);
    if (!fits(nearest)) nearest = goodValue;
    if (!fits(nearest)) return std::nullopt;
    return NearestFit{slot.number, slot.setback, restate(to.take(), wanted, lotM2)};
}

}  // namespace noonmark
