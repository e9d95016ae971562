#include "scenarios/massing/massing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/city/city.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/city/plausible_heights.h"
#include "scenarios/massing/floor_plate.h"

namespace noonmark {

namespace {

constexpr double sameLevelM = 1e-6;

tl::unexpected<Error> outOfRange(const std::string& what, double value, const char* advice) {
    return failure(fmt::format("{} cannot be {:g}", what, value), "massing", advice);
}

Result<void> checkSetbacks(const MassingSettings& settings, double fromM, double heightM) {
    double below = fromM;
    for (const Setback& setback : settings.setbacks) {
        if (!(setback.insetM > 0 && setback.insetM <= tallestBuildingM))
            return outOfRange("A setback's depth in m", setback.insetM, "Give more than 0");
        if (!(setback.aboveM > below && setback.aboveM < heightM))
            return failure(
                fmt::format("A setback cannot begin at {:g} m", setback.aboveM), "massing",
                fmt::format("Give a height between {:g} and {:g} m, from below upwards", below, heightM));
        below = setback.aboveM;
    }
    return {};
}

struct Heights {
    double podiumM = 0;
    double topM = 0;
};

Result<Heights> heightsOf(const MassingSettings& settings) {
    if (!(settings.storeyHeightM >= 2 && settings.storeyHeightM <= 10))
        return outOfRange("A storey's height in m", settings.storeyHeightM, "Give 2 to 10 m");
    if (settings.storeys < 0 || settings.storeys > 500)
        return outOfRange("The number of storeys", settings.storeys, "Give 1 to 500");
    if ((settings.storeys > 0) == (settings.heightM != 0))
        return failure("The height is given twice or not at all", "massing",
                       "Give either storeys or a total height");
    Heights heights{0, settings.storeys > 0 ? settings.storeys * settings.storeyHeightM : settings.heightM};
    if (!(heights.topM >= settings.storeyHeightM && heights.topM <= tallestBuildingM))
        return outOfRange("A height in m", heights.topM, "Give at least one storey, and at most 2000 m");
    if (!settings.podium) return heights;
    heights.podiumM = settings.podium->storeys * settings.storeyHeightM;
    if (settings.podium->storeys >= 1 && heights.podiumM < heights.topM) return heights;
    return failure(
        fmt::format("A podium of {} storeys is not lower than the whole building", settings.podium->storeys),
        "massing", fmt::format("Give 1 storey or more, below {:g} m", heights.topM));
}

// An Error that states the largest share of the lot that can be turned this far.
tl::unexpected<Error> doesNotTurn(const Footprint& lot, double degrees) {
    double fits = 0, tooLarge = 1;
    for (int i = 0; i < 10; ++i) {
        const double share = (fits + tooLarge) / 2;
        const auto plate = makePlate(lot, {.shareOfLot = share});
        (plate && liesOn(turnPlate(*plate, degrees), {lot}) ? fits : tooLarge) = share;
    }
    return failure(
        fmt::format("Turned by {:g} degrees the floor plate leaves the lot", degrees), "massing",
        fmt::format("Make the plate at most {:.0f} % of the lot, or turn it less", std::floor(fits * 100)));
}

Result<Plate> towerPlate(const Footprint& lot, const MassingSettings& settings, const Plate& ground) {
    const auto plate = makePlate(lot, settings.plate);
    if (!plate) return plate;
    const Plate there = turnPlate(*plate, settings.clockwiseDeg);
    if (settings.clockwiseDeg != 0 && !liesOn(there, {lot})) return doesNotTurn(lot, settings.clockwiseDeg);
    if (liesOn(there, ground)) return there;
    return failure(fmt::format("The tower's plate of {:.0f} m2 extends beyond its podium of {:.0f} m2",
                               computeArea(there), computeArea(ground)),
                   "massing", "Make the podium's plate larger, or the tower's smaller");
}

Result<std::vector<Tier>> tiersOn(const Footprint& lot, const MassingSettings& settings,
                                  const Heights& heights) {
    std::vector<Tier> tiers;
    Plate ground{lot};
    if (settings.podium) {
        const auto podium = makePlate(lot, settings.podium->plate);
        if (!podium) return tl::make_unexpected(podium.error());
        ground = *podium;
        tiers.push_back({.plate = ground, .bottomM = 0, .topM = heights.podiumM});
    }
    auto plate = towerPlate(lot, settings, ground);
    if (!plate) return tl::make_unexpected(plate.error());
    tiers.push_back({.plate = *plate, .bottomM = heights.podiumM, .topM = heights.topM});
    for (const Setback& setback : settings.setbacks) {
        plate = insetPlate(*plate, setback.insetM);
        if (!plate) return tl::make_unexpected(plate.error());
        tiers.back().topM = setback.aboveM;
        tiers.push_back({.plate = *plate, .bottomM = setback.aboveM, .topM = heights.topM});
    }
    return tiers;
}

Result<Footprint> usable(const Footprint& lot) {
    constexpr double leastM2 = 10;
    if (lot.outer.size() >= 3 && area(lot) >= leastM2) return lot;
    return failure("The lot is too small to build on", "massing",
                   fmt::format("Draw a lot of {:g} m2 or more", leastM2));
}

Result<void> checkSolid(const Part& part, const std::string& id) {
    const TriangleMesh mesh = meshOf(part);
    const double volume = area(part.footprint) * double(part.topM - part.bottomM);
    if (findOpenEdges(mesh) == 0 && std::abs(signedVolume(mesh) - volume) <= 1e-3 * volume) return {};
    return failure("The massing is not a closed solid", id, "Simplify the lot's outline");
}

}  // namespace

Massing assembleMassing(const Footprint& lot, std::vector<Tier> tiers, double storeyHeightM) {
    Massing massing{.tiers = std::move(tiers), .storeyHeightM = storeyHeightM};
    MassingFigures& figures = massing.figures;
    figures.lotM2 = area(lot);
    figures.heightM = massing.tiers.back().topM;
    figures.storeys = std::max(1, int(figures.heightM / storeyHeightM + sameLevelM));
    for (Tier& tier : massing.tiers) {
        tier.areaM2 = computeArea(tier.plate);
        for (int floor = 0; floor < figures.storeys; ++floor) {
            const double level = floor * storeyHeightM + sameLevelM;
            if (level >= tier.bottomM && level < tier.topM) ++tier.storeys;
        }
        figures.grossFloorM2 += tier.areaM2 * tier.storeys;
    }
    figures.floorAreaRatio = figures.grossFloorM2 / figures.lotM2;
    figures.coverage = massing.tiers.front().areaM2 / figures.lotM2;
    return massing;
}

Result<Massing> makeMassing(const Footprint& lot, const MassingSettings& settings) {
    const auto ground = usable(lot);
    if (!ground) return tl::make_unexpected(ground.error());
    const auto heights = heightsOf(settings);
    if (!heights) return tl::make_unexpected(heights.error());
    if (const auto sound = checkSetbacks(settings, heights->podiumM, heights->topM); !sound)
        return tl::make_unexpected(sound.error());
    if (!(std::abs(settings.clockwiseDeg) <= 360))
        return outOfRange("The turn in degrees", settings.clockwiseDeg, "Give -360 to 360");
    auto tiers = tiersOn(lot, settings, *heights);
    if (!tiers) return tl::make_unexpected(tiers.error());
    return assembleMassing(lot, *std::move(tiers), settings.storeyHeightM);
}

Result<Building> buildingOf(const Massing& massing, const std::string& id) {
    Building building{.sourceId = id, .name = id, .status = "proposed"};
    for (const Tier& tier : massing.tiers)
        for (const Footprint& piece : tier.plate) {
            building.parts.push_back({.sourceId = id,
                                      .footprint = piece,
                                      .bottomM = float(tier.bottomM),
                                      .topM = float(tier.topM),
                                      .heightSource = HeightSource::designed});
            if (const auto solid = checkSolid(building.parts.back(), id); !solid)
                return tl::make_unexpected(solid.error());
        }
    return building;
}

}  // namespace noonmark
