#include "scenarios/massing/fit_floor_area.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/city/building_heights.h"
#include "core/describe/choice.h"
#include "core/describe/text.h"

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

namespace {

constexpr double closeEnough = 0.0005;  // of the floor area
constexpr double minPlateM2 = 1;

std::optional<double> floorAreaOf(const Footprint& lot, const MassingSettings& settings) {
    const auto massing = makeMassing(lot, settings);
    return massing ? std::optional(massing->figures.grossFloorM2) : std::nullopt;
}

MassingSettings withStoreys(MassingSettings settings, int storeys) {
    settings.storeys = storeys;
    settings.heightM = 0;
    return settings;
}

MassingSettings withPlate(MassingSettings settings, double plateM2) {
    settings.plate = {.areaM2 = plateM2};
    return settings;
}

// Above the podium and the last setback.
int findFewestStoreys(const MassingSettings& settings) {
    int fewest = settings.podium ? settings.podium->storeys + 1 : 1;
    if (!settings.setbacks.empty())
        fewest = std::max(fewest, int(settings.setbacks.back().aboveM / settings.storeyHeightM) + 1);
    return fewest;
}

tl::unexpected<Error> outOfReach(double wantedM2, const std::string& reached, const char* advice) {
    return failure(fmt::format("A floor area of {:.0f} m2 cannot be reached: {}", wantedM2, reached),
                   "massing", advice);
}

Result<MassingSettings> fitStoreys(const Footprint& lot, const MassingSettings& settings, double wantedM2) {
    int fits = findFewestStoreys(settings);
    const auto minimum = floorAreaOf(lot, withStoreys(settings, fits));
    if (!minimum) return tl::make_unexpected(makeMassing(lot, withStoreys(settings, fits)).error());
    if (*minimum > wantedM2)
        return outOfReach(wantedM2, fmt::format("{} storeys have {:.0f} m2 already", fits, *minimum),
                          "Make the plate or the podium smaller");
    int tooMany = std::min(maxStoreys, int(tallestBuildingM / settings.storeyHeightM)) + 1;
    if (const auto maximum = floorAreaOf(lot, withStoreys(settings, tooMany - 1));
        maximum && *maximum < wantedM2)
        return outOfReach(wantedM2, fmt::format("{} storeys have {:.0f} m2", tooMany - 1, *maximum),
                          "Make the plate larger");
    while (tooMany - fits > 1) {
        const int storeys = (fits + tooMany) / 2;
        const auto areaM2 = floorAreaOf(lot, withStoreys(settings, storeys));
        (areaM2 && *areaM2 <= wantedM2 * (1 + 1e-9) ? fits : tooMany) = storeys;
    }
    return withStoreys(settings, fits);
}

// A plate may be too small for the setbacks, or too large for a lot that it is turned on.
Result<MassingSettings> fitPlate(const Footprint& lot, const MassingSettings& settings, double wantedM2) {
    const auto now = makeMassing(lot, settings);
    if (!now) return tl::make_unexpected(now.error());
    const std::size_t tower = settings.podium ? 1 : 0;
    const double nowM2 = now->tiers[tower].areaM2;
    double fitsM2 = nowM2, fitsFloorM2 = now->figures.grossFloorM2;
    double tooSmallM2 = 0, tooLargeM2 = area(lot);
    if (fitsFloorM2 < wantedM2)
        if (const auto whole = floorAreaOf(lot, withPlate(settings, tooLargeM2)); whole && *whole <= wantedM2)
            fitsM2 = tooLargeM2, fitsFloorM2 = *whole;
    while (std::abs(fitsFloorM2 - wantedM2) > closeEnough * wantedM2 &&
           tooLargeM2 - tooSmallM2 > minPlateM2) {
        const double plateM2 = (tooSmallM2 + tooLargeM2) / 2;
        const auto areaM2 = floorAreaOf(lot, withPlate(settings, plateM2));
        (areaM2 ? *areaM2 < wantedM2 : plateM2 < nowM2) ? tooSmallM2 = plateM2 : tooLargeM2 = plateM2;
        if (areaM2) fitsM2 = plateM2, fitsFloorM2 = *areaM2;
    }
    if (std::abs(fitsFloorM2 - wantedM2) <= 2 * closeEnough * wantedM2) return withPlate(settings, fitsM2);
    return outOfReach(wantedM2, fmt::format("a plate of {:.0f} m2 gives {:.0f} m2", fitsM2, fitsFloorM2),
                      fitsFloorM2 < wantedM2 ? "Give more storeys or a larger lot"
                                             : "Give fewer storeys or a smaller podium");
}

constexpr Choice<FloorAreaBy> waysToFit[] = {{FloorAreaBy::storeys, "storeys", NM_TEXT("Storeys")},
                                             {FloorAreaBy::plate, "plate", NM_TEXT("Floor plate")}};

}  // namespace

std::optional<double> FloorAreaTarget::areaOn(const Footprint& lot) const {
    if (grossFloorM2) return grossFloorM2;
    return floorAreaRatio ? std::optional(*floorAreaRatio * area(lot)) : std::nullopt;
}

const Fields<FloorAreaTarget>& floorAreaFields() {
    static const Fields<FloorAreaTarget> fields{
        field(&FloorAreaTarget::grossFloorM2,
              {.key = "gross_floor_m2",
               .flag = "--floor-area",
               .label = NM_TEXT("Gross floor area"),
               .help = "Gross floor area that the tower shall have; see --fit",
               .hint = "M2",
               .unit = "m2",
               .range = ValueRange{1, 1e9}}),
        field(&FloorAreaTarget::floorAreaRatio, {.key = "floor_area_ratio",
                                                 .flag = "--floor-area-ratio",
                                                 .label = NM_TEXT("Floor area ratio (FAR)"),
                                                 .help = "The same, as a multiple of the lot's area",
                                                 .hint = "RATIO",
                                                 .range = ValueRange{0.01, 1000},
                                                 .excludes = {"--floor-area"}}),
        choiceField(&FloorAreaTarget::by, std::span(waysToFit),
                    {.key = "fit",
                     .flag = "--fit",
                     .label = NM_TEXT("Fit"),
                     .help = "What is chosen for the floor area: the most storeys that stay within it, or "
                             "the size of the floor plate"})};
    return fields;
}

Result<MassingSettings> fitFloorArea(const Footprint& lot, const MassingSettings& settings, double wantedM2,
                                     FloorAreaBy by) {
    if (!(wantedM2 > 0))
        return failure(fmt::format("A tower cannot have a floor area of {:g} m2", wantedM2), "massing",
                       "Give more than 0");
    return by == FloorAreaBy::storeys ? fitStoreys(lot, settings, wantedM2)
                                      : fitPlate(lot, settings, wantedM2);
}

}  // namespace noonmark
