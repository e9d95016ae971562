#include "scenarios/massing/copy_massing.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/city/footprints/plan_areas.h"
#include "core/city/meshes/mesh_outline.h"

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

namespace {

Result<void> validate(const Footprint& lot, const PreservedFloorArea& given, double plateFactor) {
    if (!(plateFactor > 0))
        return failure(fmt::format("A floor plate cannot be {:g} times as large", plateFactor), "variant",
                       "Give a factor over 0");
    if (given.plate.empty() || !(given.grossFloorM2 > 0))
        return failure("The given massing has no floor area", "variant", "Choose another building");
    if (liesOn(given.plate, {lot})) return {};
    return failure("The given massing does not stand on the lot", "variant",
                   "Choose the lot that it stands on, or draw one around it");
}

int storeysFor(double grossFloorM2, double plateM2, bool wider) {
    const double storeys = grossFloorM2 / plateM2;
    // Rounding up keeps a wider plate within its limit.
    return std::max(1, int(wider ? std::ceil(storeys - 1e-6) : std::round(storeys)));
}

// For a mesh that leans outwards above its base, the base counts.
Plate plateOf(const Building& building, double groundM, double storeyHeightM) {
    const bool anyMesh =
        std::ranges::any_of(building.parts, [](const Part& part) { return part.mesh != nullptr; });
    if (Plate foot = anyMesh ? findGroundFloor(building, groundM, storeyHeightM) : Plate(); !foot.empty())
        return foot;
    Plate ground;
    for (const Part& part : building.parts)
        if (double(part.bottomM) <= groundM + 0.5) ground.push_back(part.footprint);
    return computeUnion(ground);
}

}  // namespace

PreservedFloorArea massOf(const Massing& massing) {
    return {massing.tiers.front().plate, massing.figures.grossFloorM2, massing.storeyHeightM};
}

Result<PreservedFloorArea> massOf(const Building& building, double groundM, double storeyHeightM) {
    if (!(storeyHeightM >= 2 && storeyHeightM <= 10))
        return failure(fmt::format("A storey cannot be {:g} m high", storeyHeightM), "variant",
                       "Give 2 to 10 m");
    const FloorArea floors = computeFloorArea(building, groundM, storeyHeightM);
    PreservedFloorArea given{.plate = plateOf(building, groundM, storeyHeightM),
                             .grossFloorM2 = floors.grossM2,
                             .storeyHeightM = storeyHeightM,
                             .estimatedStoreys = floors.estimatedStoreys};
    if (given.grossFloorM2 > 0 && !given.plate.empty()) return given;
    return failure("The building has less than one storey", building.sourceId, "Choose another building");
}

Result<Massing> findSameFloorArea(const Footprint& lot, const PreservedFloorArea& given, double plateFactor) {
    if (const auto sound = validate(lot, given, plateFactor); !sound)
        return tl::make_unexpected(sound.error());
    const bool wider = plateFactor > 1;
    const double wanted = std::min(area(lot), area(given.plate) * plateFactor);
    const int storeys = storeysFor(given.grossFloorM2, wanted, wider);
    const int maximum = std::min(maxStoreys, int(tallestBuildingM / given.storeyHeightM));
    if (storeys > maximum)
        return failure(fmt::format("The tower would have {} storeys", storeys), "variant",
                       fmt::format("Give a floor plate of {:.0f} m2 or more: {} storeys",
                                   given.grossFloorM2 / maximum, maximum));
    const double plateM2 = std::min(given.grossFloorM2 / storeys, area(lot));
    Tier tier{.plate = resizePlate(given.plate, lot, plateM2), .topM = storeys * given.storeyHeightM};
    Massing massing = assembleMassing(lot, {std::move(tier)}, given.storeyHeightM);
    if (std::abs(massing.figures.grossFloorM2 - given.grossFloorM2) <= 0.001 * given.grossFloorM2)
        return massing;
    return failure(fmt::format("The lot allows {:.0f} m2 of the {:.0f} m2 of floor area",
                               massing.figures.grossFloorM2, given.grossFloorM2),
                   "variant", "Choose another floor plate");
}

}  // namespace noonmark
