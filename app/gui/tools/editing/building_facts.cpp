#include "app/gui/tools/editing/building_facts.h"

#include <algorithm>
#include <cmath>

#include "app/gui/base/widgets/height_words.h"
#include "core/city/terrain/building_ground.h"
#include "scenarios/massing/lot_edits.h"
#include "scenarios/massing/same_floor_area.h"

namespace noonmark {

namespace {

QString describeSource(HeightSource source) {
    switch (source) {
        case HeightSource::measured:
            return QObject::tr("measured");
        case HeightSource::levels:
            return QObject::tr("from its storeys");
        case HeightSource::assumed:
            return QObject::tr("assumed");
        case HeightSource::mesh:
            return QObject::tr("from its mesh");
        case HeightSource::designed:
            return QObject::tr("designed");
        case HeightSource::madeUp:
            return QObject::tr("synthetic");
    }
    return {};
}

Result<GivenMass> massOf(const Building& building, const City& city, double storeyHeightM = defaultStoreyM) {
    return givenBy(building, double(findGroundUnder(building, city)), storeyHeightM);
}

}  // namespace

BuildingFacts collectFacts(const Building& building, const City& city, const ProposedTower* tower) {
    BuildingFacts facts;
    facts.id = QString::fromStdString(building.sourceId);
    facts.title = building.name.empty() ? facts.id : QString::fromStdString(building.name);
    facts.heightM = double(heightM(building, city));
    facts.groundElevationM =
        computeElevation(city, {findMiddle(building), double(findGroundUnder(building, city))});
    facts.parts = building.parts.size();
    const auto highest = std::ranges::max_element(building.parts, {}, &Part::topM);
    if (highest != building.parts.end()) facts.heightSource = describeSource(highest->heightSource);
    if (tower != nullptr && tower->storeyHeightM > 0) facts.storeyHeightM = tower->storeyHeightM;
    facts.storeys = int(std::lround(facts.heightM / facts.storeyHeightM));
    if (const auto mass = massOf(building, city, facts.storeyHeightM)) {
        facts.planM2 = computeArea(mass->plate);
        facts.grossFloorM2 = mass->grossFloorM2;
        facts.estimatedStoreys = mass->estimatedStoreys;
    }
    const auto figures = tower != nullptr ? figuresOf(*tower) : std::nullopt;
    if (!figures) return facts;
    facts.designed = true;
    facts.storeys = figures->storeys;
    facts.grossFloorM2 = figures->grossFloorM2;
    return facts;
}

GroupFacts collectFacts(std::span<const std::uint32_t> buildings, const City& city) {
    GroupFacts facts{.buildings = buildings.size()};
    for (const std::uint32_t building : buildings) {
        const auto mass = massOf(*city.buildings[building], city);
        mass ? void(facts.grossFloorM2 += mass->grossFloorM2) : void(++facts.unmeasured);
    }
    return facts;
}

std::optional<Footprint> lotUnder(const Building& building, const City& city) {
    const auto mass = massOf(building, city);
    if (!mass) return std::nullopt;
    return *std::ranges::max_element(mass->plate, {}, [](const Footprint& piece) { return area(piece); });
}

}  // namespace noonmark
