#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <span>

#include "core/city/city.h"
#include "core/city/storeys.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark {

/// Facts about a building for the selection panel.
struct BuildingFacts {
    QString title;  ///< name, or id if it has none
    QString id;
    double heightM = 0;           ///< above the ground at the building
    double groundElevationM = 0;  ///< of that ground, above the datum
    QString heightSource;
    double storeyHeightM = defaultStoreyM;  ///< of the design, else the usual one
    bool designed = false;                  ///< storeys and floor area are those of a design
    int storeys = 0;                        ///< 0: less than one
    std::size_t parts = 0;
    double planM2 = 0;         ///< area of the parts that touch the ground
    double grossFloorM2 = 0;   ///< of these storeys
    int estimatedStoreys = 0;  ///< storeys of that area that are estimated, because the mesh is open
};

/// Facts about several buildings.
struct GroupFacts {
    std::size_t buildings = 0;
    double grossFloorM2 = 0;     ///< together, at defaultStoreyM per storey
    std::size_t unmeasured = 0;  ///< buildings without a storey on the ground, which that sum lacks
};
GroupFacts collectFacts(std::span<const std::uint32_t> buildings, const City& city);

/// `tower`: what is known of it as a tower of the scenario; null: nothing. Takes some ms for a building of
/// hundreds of points.
BuildingFacts collectFacts(const Building& building, const City& city, const ProposedTower* tower = nullptr);

/// The largest piece of the building's outline on the ground, as a lot. Nothing if no part touches the
/// ground.
std::optional<Footprint> lotUnder(const Building& building, const City& city);

}  // namespace noonmark
