#include "scenarios/massing/fit_floor_area.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/city/plausible_heights.h"
#include "core/describe/choice.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

constexpr int mostStoreys = 500;
constexpr double closeEnough = 0.0005;  // of the floor area
constexpr double leastPlateM2 = 1;

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
    const auto least = floorAreaOf(lot, withStoreys(settings, fits));
    if (!least) return tl::make_unexpected(makeMassing(lot, withStoreys(settings, fits)).error());
    if (*least > wantedM2)
        return outOfReach(wantedM2, fmt::format("{} storeys have {:.0f} m2 already", fits, *least),
                          "Make the plate or the podium smaller");
    int tooMany = std::min(mostStoreys, int(tallestBuildingM / settings.storeyHeightM)) + 1;
    if (const auto most = floorAreaOf(lot, withStoreys(settings, tooMany - 1)); most && *most < wantedM2)
        return outOfReach(wantedM2, fmt::format("{} storeys have {:.0f} m2", tooMany - 1, *most),
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
           tooLargeM2 - tooSmallM2 > leastPlateM2) {
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
