#pragma once

// The folder scenarios/massing/ builds towers on lots. massing.h extrudes one from a user's settings;
// floor_plate.h computes its plates with straight_skeleton.h (backend CGAL); same_floor_area.h reshapes a
// building at constant gross floor area; lot_edits.h turns massings into edits of a city.

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/building.h"

namespace noonmark {

/// Size of a floor plate: a share of the lot or an area. With neither, the plate is the whole lot.
struct PlateSize {
    std::optional<double> shareOfLot;  ///< more than 0, at most 1
    std::optional<double> areaM2;      ///< more than 0, at most the lot's area
    bool operator==(const PlateSize&) const = default;
};

/// Above `aboveM` the walls are inset by `insetM`.
struct Setback {
    double aboveM = 0;  ///< above the ground; less than the tower's height
    double insetM = 0;  ///< more than 0, perpendicular to every wall, courtyard walls included
    bool operator==(const Setback&) const = default;
};

struct Podium {
    int storeys = 1;  ///< fewer than the whole building has
    PlateSize plate;
    bool operator==(const Podium&) const = default;
};

/// User settings for a tower on a lot.
struct MassingSettings {
    double storeyHeightM = 3.5;  ///< 2 to 10
    int storeys = 0;             ///< in total, podium included: 1 to 500; 0: as many as fit into heightM
    double heightM = 0;          ///< 0: storeys x storey height; else 2 to 2000
    PlateSize plate;             ///< of the tower at its base
    std::optional<Podium> podium;
    std::vector<Setback> setbacks;  ///< from bottom to top
    double clockwiseDeg = 0;  ///< turns the tower about the centroid of its plate; it must stay on the lot
    bool operator==(const MassingSettings&) const = default;
};

/// One prism of a massing. Its plate has several pieces where insets split it.
struct Tier {
    std::vector<Footprint> plate;
    double bottomM = 0;  ///< above the ground
    double topM = 0;
    int storeys = 0;  ///< number of floors in it
    double areaM2 = 0;
};

struct MassingFigures {
    double lotM2 = 0;
    double grossFloorM2 = 0;    ///< sum of plate x storeys
    double floorAreaRatio = 0;  ///< gross floor area / lot
    double coverage = 0;        ///< share of the lot that is covered
    double heightM = 0;
    int storeys = 0;
};

struct Massing {
    std::vector<Tier> tiers;  ///< from bottom to top, each inside the one below
    double storeyHeightM = 0;
    MassingFigures figures;
};

/// Extrudes a tower on a lot. A plate smaller than the lot is the straight-skeleton inset of the lot with
/// that area: it keeps the lot's shape and enlarges its courtyards. A floor belongs to the tier that contains
/// its level; height left over after whole storeys goes to the last storey. Error, with the limit: a setting
/// out of range, a plate larger than the lot, an inset that leaves nothing, a turned plate that leaves the
/// lot, or a podium as high as the whole building. About 5 ms per plate.
Result<Massing> makeMassing(const Footprint& lot, const MassingSettings& settings);

/// Builds a massing from given tiers and computes its figures, for shapes that do not come from settings.
Massing assembleMassing(const Footprint& lot, std::vector<Tier> tiers, double storeyHeightM);

/// A building of prisms on z = 0 with status "proposed", one part per piece of a tier. Error: a prism is not
/// a closed, outward-oriented solid of the expected volume.
Result<Building> buildingOf(const Massing& massing, const std::string& id);

}  // namespace noonmark
