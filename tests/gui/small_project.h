#pragma once

#include <QTemporaryDir>

#include "scenarios/edits/apply_edits.h"
#include "scenarios/project/project_file.h"
#include "tests/gui/small_city.h"

namespace noonmark::test {

/// A project of the small city with ids, a lot, a region and a period.
inline Project smallProject() {
    Project project;
    project.city = std::make_shared<const City>(makeIdsUnique(smallCity()));
    project.attribution = "Nobody";
    project.lots.push_back({"Yard", square({20, 20}, 30)});
    project.regions.push_back({"Square", {square({-80, -80}, 160)}});
    project.periods.push_back({"Spring", {}});
    return project;
}

/// The id of a building of the small city: 0 South House, 1 Low House, 2 Tower.
inline std::string idOf(const Project& project, std::size_t building) {
    return project.city->buildings[building]->sourceId;
}

inline Edit newTower(const std::string& id, float heightM) {
    Building building{.sourceId = id, .name = id};
    building.parts.push_back({.sourceId = id,
                              .footprint = square({20, 20}, 20),
                              .topM = heightM,
                              .heightSource = HeightSource::measured});
    return AddBuilding{std::make_shared<const Building>(std::move(building))};
}

}  // namespace noonmark::test
