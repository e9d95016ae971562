#include "scenarios/massing/same_floor_area.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/city/footprints/floor_area.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/city/plausible_heights.h"

namespace noonmark {

namespace {

constexpr int maxStoreys = 500;

Result<void> validate(const Footprint& lot, const GivenMass& given, double plateFactor) {
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

GivenMass givenBy(const Massing& massing) {
    return {massing.tiers.front().plate, massing.figures.grossFloorM2, massing.storeyHeightM};
}

Result<GivenMass> givenBy(const Building& building, double groundM, double storeyHeightM) {
    if (!(storeyHeightM >= 2 && storeyHeightM <= 10))
        return failure(fmt::format("A storey cannot be {:g} m high", storeyHeightM), "variant",
                       "Give 2 to 10 m");
    const FloorArea floors = computeFloorArea(building, groundM, storeyHeightM);
    GivenMass given{.plate = plateOf(building, groundM, storeyHeightM),
                    .grossFloorM2 = floors.grossM2,
                    .storeyHeightM = storeyHeightM,
                    .estimatedStoreys = floors.estimatedStoreys};
    if (given.grossFloorM2 > 0 && !given.plate.empty()) return given;
    return failure("The building has less than one storey", building.sourceId, "Choose another building");
}

Result<Massing> findSameFloorArea(const Footprint& lot, const GivenMass& given, double plateFactor) {
    if (const auto sound = validate(lot, given, plateFactor); !sound)
        return tl::make_unexpected(sound.error());
    const bool wider = plateFactor > 1;
    const double wanted = std::min(area(lot), computeArea(given.plate) * plateFactor);
    const int storeys = storeysFor(given.grossFloorM2, wanted, wider);
    const int most = std::min(maxStoreys, int(tallestBuildingM / given.storeyHeightM));
    if (storeys > most)
        return failure(fmt::format("The tower would have {} storeys", storeys), "variant",
                       fmt::format("Give a floor plate of {:.0f} m2 or more: {} storeys",
                                   given.grossFloorM2 / most, most));
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
