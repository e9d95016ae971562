#include "scenarios/massing/massing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <utility>

#include "core/city/building_heights.h"
#include "core/city/city.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_topology.h"
#include "scenarios/massing/floor_plate.h"
#include "scenarios/massing/massing_fields.h"

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
    if ((settings.storeys > 0) == (settings.heightM != 0))
        return failure("The height is given twice or not at all", "massing",
                       "Give either storeys or a total height");
    Heights heights{0, heightOf(settings)};
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
                               area(there), area(ground)),
                   "massing", "Make the podium's plate larger, or the tower's smaller");
}

Result<std::vector<Tier>> tiersOn(const Footprint& lot, const MassingSettings& settings,
                                  const Heights& heights) {
    std::vector<Tier> tiers;
    Plate ground{lot};
    if (settings.podium) {
        const auto podium = makePlate(lot, settings.podium->plate);
        if (!podium) return tl::make_unexpected(podium.error());
        tiers.push_back(
            {.plate = *podium, .bottomM = 0, .topM = heights.podiumM, .walls = settings.podium->walls});
        ground = topPlateOf(tiers.back());
    }
    auto plate = towerPlate(lot, settings, ground);
    if (!plate) return tl::make_unexpected(plate.error());
    tiers.push_back(
        {.plate = *plate, .bottomM = heights.podiumM, .topM = heights.topM, .walls = settings.walls});
    for (const Setback& setback : settings.setbacks) {
        tiers.back().topM = setback.aboveM;
        plate = insetPlate(topPlateOf(tiers.back()), setback.insetM);
        if (!plate) return tl::make_unexpected(plate.error());
        tiers.push_back(
            {.plate = *plate, .bottomM = setback.aboveM, .topM = heights.topM, .walls = setback.walls});
    }
    return tiers;
}

Result<void> checkTwists(const std::vector<Tier>& tiers, const Footprint& lot) {
    for (const Tier& tier : tiers)
        if (!staysOn(tier, lot))
            return failure(fmt::format("Twisted by {:g} degrees, the volume from {:g} m up leaves the lot",
                                       tier.walls.twistDeg, tier.bottomM),
                           "massing", "Make its plate smaller, twist it less, or taper it more");
    return {};
}

Result<Footprint> usable(const Footprint& lot) {
    constexpr double minM2 = 10;
    if (lot.outer.size() >= 3 && area(lot) >= minM2) return lot;
    return failure("The lot is too small to build on", "massing",
                   fmt::format("Draw a lot of {:g} m2 or more", minM2));
}

// A twisted wall of triangles differs a little from the ideal one.
Result<void> checkSolid(const Part& part, const Footprint& piece, const WallShape& walls) {
    const TriangleMesh mesh = meshOf(part);
    const double scale = 1 - walls.taper;
    const double volume = area(piece) * double(part.topM - part.bottomM) * (1 + scale + scale * scale) / 3;
    const double allowed = walls.twistDeg == 0 ? 1e-3 : 5e-3;
    if (findOpenEdges(mesh) == 0 && std::abs(signedVolume(mesh) - volume) <= allowed * volume) return {};
    return failure("The massing is not a closed solid", part.sourceId, "Simplify the lot's outline");
}

// One piece of the plate at some of the mesh's levels, no more than 10 degrees apart.
std::vector<Footprint> makeSections(const Tier& tier, const Footprint& piece, double storeyHeightM) {
    const std::vector<double> levels = levelsOf(tier, storeyHeightM);
    const auto count = std::size_t(std::ceil(std::abs(tier.walls.twistDeg) / 10)) + 1;
    const auto index = std::size_t(std::ranges::find(tier.plate, piece) - tier.plate.begin());
    std::vector<Footprint> sections;
    for (std::size_t i = 0; i <= count; ++i)
        sections.push_back(plateAt(tier, levels[i * (levels.size() - 1) / count]).at(index));
    return sections;
}

// The part's footprint is its outline seen from above, which a twist makes larger than any of its plates.
Result<Part> makeLeaningPart(const Tier& tier, const Footprint& piece, Part part, double storeyHeightM) {
    auto mesh = std::make_shared<TriangleMesh>(makeLeaningMesh(tier, piece, storeyHeightM));
    if (tier.walls.twistDeg != 0) {
        std::vector<Footprint> outline =
            computeOutline(*mesh, true, makeSections(tier, piece, storeyHeightM)).pieces;
        if (outline.empty())
            return failure("The outline of the twisted volume cannot be determined", part.sourceId,
                           "Twist it less");
        part.footprint =
            *std::ranges::max_element(outline, {}, [](const Footprint& one) { return area(one); });
    }
    // Its corners lean outwards, if only a little: as a heightfield, the ground under them would count as
    // built on, which adds over one percent to a tower's shadow.
    part.isOverhanging = tier.walls.twistDeg != 0;
    part.mesh = std::move(mesh);
    return part;
}

Result<Part> makePart(const Tier& tier, const Footprint& piece, const std::string& id, double storeyHeightM) {
    Part part{.sourceId = id,
              .footprint = piece,
              .bottomM = float(tier.bottomM),
              .topM = float(tier.topM),
              .heightSource = HeightSource::designed};
    if (tier.walls.upright()) return part;
    return makeLeaningPart(tier, piece, std::move(part), storeyHeightM);
}

}  // namespace

double heightOf(const MassingSettings& settings) {
    return settings.storeys > 0 ? settings.storeys * settings.storeyHeightM : settings.heightM;
}

MassingSettings withHeight(MassingSettings settings, double heightM) {
    const double storeys = heightM / settings.storeyHeightM;
    const bool whole = std::abs(storeys - std::round(storeys)) < 1e-6;
    settings.storeys = whole ? int(std::round(storeys)) : 0;
    settings.heightM = whole ? 0 : heightM;
    return settings;
}

Massing assembleMassing(const Footprint& lot, std::vector<Tier> tiers, double storeyHeightM) {
    Massing massing{.tiers = std::move(tiers), .storeyHeightM = storeyHeightM};
    massing.firstTiers = massing.tiers.size();
    MassingFigures& figures = massing.figures;
    figures.lotM2 = area(lot);
    figures.heightM = massing.tiers.back().topM;
    figures.storeys = std::max(1, int(figures.heightM / storeyHeightM + sameLevelM));
    for (Tier& tier : massing.tiers) {
        tier.areaM2 = area(tier.plate);
        for (int floor = 0; floor < figures.storeys; ++floor) {
            const double level = floor * storeyHeightM + sameLevelM;
            if (level < tier.bottomM || level >= tier.topM) continue;
            ++tier.storeys;
            massing.storeyM2.push_back(plateAreaAt(tier, level - sameLevelM));
            figures.grossFloorM2 += massing.storeyM2.back();
        }
    }
    figures.floorAreaRatio = figures.grossFloorM2 / figures.lotM2;
    figures.coverage = massing.tiers.front().areaM2 / figures.lotM2;
    return massing;
}

namespace {

Result<Massing> makeOneTower(const Footprint& lot, const MassingSettings& settings) {
    const auto ground = usable(lot);
    if (!ground) return tl::make_unexpected(ground.error());
    if (const auto sound = checkRanges(settings); !sound) return tl::make_unexpected(sound.error());
    const auto heights = heightsOf(settings);
    if (!heights) return tl::make_unexpected(heights.error());
    if (const auto sound = checkSetbacks(settings, heights->podiumM, heights->topM); !sound)
        return tl::make_unexpected(sound.error());
    if (const auto sound = checkUses(settings.uses); !sound) return tl::make_unexpected(sound.error());
    auto tiers = tiersOn(lot, settings, *heights);
    if (!tiers) return tl::make_unexpected(tiers.error());
    if (const auto inside = checkTwists(*tiers, lot); !inside) return tl::make_unexpected(inside.error());
    Massing massing = assembleMassing(lot, *std::move(tiers), settings.storeyHeightM);
    massing.figures.uses = sumByUse(settings.uses, massing.storeyM2);
    return massing;
}

// Unit vector along the longest side.
glm::dvec2 findLongestSide(const Ring& ring) {
    glm::dvec2 longest{1, 0};
    double lengthM = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 side = glm::dvec2(ring[(i + 1) % ring.size()]) - glm::dvec2(ring[i]);
        if (glm::length(side) <= lengthM) continue;
        lengthM = glm::length(side);
        longest = side / lengthM;
    }
    return longest;
}

// What of the lot lies between two distances along a direction; the largest of several pieces.
Footprint cutStrip(const Footprint& lot, glm::dvec2 along, double fromM, double toM) {
    constexpr double farM = 1e5;
    const glm::dvec2 aside(-along.y, along.x);
    const auto corner = [&](double alongM, double asideM) {
        return glm::vec2(along * alongM + aside * asideM);
    };
    const Footprint strip{{corner(fromM, -farM), corner(toM, -farM), corner(toM, farM), corner(fromM, farM)},
                          {}};
    const std::vector<Footprint> pieces = cutSharedPieces({lot}, {strip});
    if (pieces.empty()) return {};
    return *std::ranges::max_element(pieces, {}, [](const Footprint& piece) { return area(piece); });
}

Result<std::vector<Footprint>> divideLot(const Footprint& lot, std::size_t towers, double gapM) {
    const glm::dvec2 along = findLongestSide(lot.outer);
    double fromM = std::numeric_limits<double>::max(), toM = -fromM;
    for (const glm::vec2& corner : lot.outer) {
        fromM = std::min(fromM, glm::dot(glm::dvec2(corner), along));
        toM = std::max(toM, glm::dot(glm::dvec2(corner), along));
    }
    const double widthM = (toM - fromM - gapM * double(towers - 1)) / double(towers);
    std::vector<Footprint> pieces;
    for (std::size_t i = 0; widthM > 0 && i < towers; ++i) {
        const double beginM = fromM + double(i) * (widthM + gapM);
        pieces.push_back(cutStrip(lot, along, beginM, beginM + widthM));
        if (!usable(pieces.back())) break;
    }
    if (pieces.size() == towers && usable(pieces.back())) return pieces;
    return failure(
        fmt::format("The lot is too small for {} towers {:g} m apart", towers, gapM), "massing",
        fmt::format("Its longest side is {:.0f} m: plan fewer towers, or a narrower gap", toM - fromM));
}

// A share is of the whole lot, and a plate of all of it that of the whole piece.
PlateSize onPiece(const PlateSize& plate, double lotM2) {
    const double m2 = plate.areaM2.value_or(plate.shareOfLot.value_or(1) * lotM2);
    return m2 < lotM2 * (1 - 1e-9) ? PlateSize{.areaM2 = m2} : PlateSize{};
}

/// The settings of each tower alone, from the first.
std::vector<MassingSettings> listTowers(MassingSettings settings, double lotM2) {
    const std::vector<FurtherTower> further = std::exchange(settings.further, {});
    settings.plate = onPiece(settings.plate, lotM2);
    if (settings.podium) settings.podium->plate = onPiece(settings.podium->plate, lotM2);
    std::vector<MassingSettings> towers{settings};
    for (const FurtherTower& tower : further)
        towers.push_back({.storeyHeightM = settings.storeyHeightM,
                          .storeys = tower.storeys,
                          .plate = onPiece(tower.plate, lotM2)});
    return towers;
}

// The storeys of a tower without uses have none beside those that do.
void addTower(Massing& all, Massing tower) {
    MassingFigures &sum = all.figures, &one = tower.figures;
    if (!sum.uses.empty()) sum.uses.push_back({{}, one.storeys, one.grossFloorM2});
    sum.grossFloorM2 += one.grossFloorM2;
    sum.coverage += one.coverage * one.lotM2 / sum.lotM2;
    sum.heightM = std::max(sum.heightM, one.heightM);
    sum.storeys = std::max(sum.storeys, one.storeys);
    sum.floorAreaRatio = sum.grossFloorM2 / sum.lotM2;
    all.storeyM2.resize(std::max(all.storeyM2.size(), tower.storeyM2.size()));
    for (std::size_t i = 0; i < tower.storeyM2.size(); ++i) all.storeyM2[i] += tower.storeyM2[i];
    std::ranges::move(tower.tiers, std::back_inserter(all.tiers));
}

}  // namespace

Result<Massing> makeMassing(const Footprint& lot, const MassingSettings& settings) {
    if (settings.further.empty()) return makeOneTower(lot, settings);
    if (const auto sound = checkRanges(settings); !sound) return tl::make_unexpected(sound.error());
    const auto pieces = divideLot(lot, settings.further.size() + 1, settings.gapM);
    if (!pieces) return tl::make_unexpected(pieces.error());
    const std::vector<MassingSettings> towers = listTowers(settings, area(lot));
    std::optional<Massing> all;
    for (std::size_t i = 0; i < towers.size(); ++i) {
        auto tower = makeOneTower((*pieces)[i], towers[i]);
        if (!tower)
            return failure(fmt::format("Tower {} of {}: {}", i + 1, towers.size(), tower.error().what),
                           tower.error().where, tower.error().advice);
        if (all) {
            addTower(*all, *std::move(tower));
            continue;
        }
        all = *std::move(tower);
        all->figures.coverage *= all->figures.lotM2 / area(lot);
        all->figures.lotM2 = area(lot);
        all->figures.floorAreaRatio = all->figures.grossFloorM2 / area(lot);
    }
    return *std::move(all);
}

Result<Building> buildingOf(const Massing& massing, const std::string& id) {
    Building building{.sourceId = id, .name = id, .status = "proposed"};
    for (const Tier& tier : massing.tiers)
        for (const Footprint& piece : tier.plate) {
            auto part = makePart(tier, piece, id, massing.storeyHeightM);
            if (!part) return tl::make_unexpected(part.error());
            if (const auto solid = checkSolid(*part, piece, tier.walls); !solid)
                return tl::make_unexpected(solid.error());
            building.parts.push_back(*std::move(part));
        }
    return building;
}

}  // namespace noonmark
