#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/building.h"

namespace noonmark {

/// How large a floor plate is: a share of the lot, or an area; with neither it is the whole lot.
struct PlateSize {
    std::optional<double> shareOfLot;  ///< over 0, at most 1
    std::optional<double> areaM2;      ///< over 0, at most the lot's
    bool operator==(const PlateSize&) const = default;
};

/// Above `aboveM` the walls stand `insetM` further in.
struct Setback {
    double aboveM = 0;  ///< above the ground; inside the tower's height
    double insetM = 0;  ///< over 0, square to every wall, courtyards' walls too
    bool operator==(const Setback&) const = default;
};

struct Podium {
    int storeys = 1;  ///< fewer than the whole
    PlateSize plate;
    bool operator==(const Podium&) const = default;
};

/// What a user states of a tower on a lot.
struct MassingSettings {
    double storeyHeightM = 3.5;  ///< 2 to 10
    int storeys = 0;             ///< all of them, the podium's too: 1 to 500; 0: as many as fit into heightM
    double heightM = 0;          ///< 0: storeys x storey height; else 2 to 2000
    PlateSize plate;             ///< of the tower where it begins
    std::optional<Podium> podium;
    std::vector<Setback> setbacks;  ///< from below upwards
    double clockwiseDeg = 0;        ///< the tower turned about the middle of its plate; must stay on the lot
    bool operator==(const MassingSettings&) const = default;
};

/// One prism of a massing; its plate may be in several pieces where insets part it.
struct Tier {
    std::vector<Footprint> plate;
    double bottomM = 0;  ///< above the ground
    double topM = 0;
    int storeys = 0;  ///< floors that lie in it
    double areaM2 = 0;
};

struct MassingFigures {
    double lotM2 = 0;
    double grossFloorM2 = 0;    ///< sum of plate x storeys
    double floorAreaRatio = 0;  ///< gross floor area / lot
    double coverage = 0;        ///< share of the lot that is built on
    double heightM = 0;
    int storeys = 0;
};

struct Massing {
    std::vector<Tier> tiers;  ///< from below upwards, each inside the one below
    double storeyHeightM = 0;
    MassingFigures figures;
};

/// Extrudes a tower on a lot. A plate smaller than the lot is the lot's straight-skeleton inset of that area:
/// it keeps the lot's shape and its courtyards (grown). A floor belongs to the tier in which its level lies;
/// what height is left over after whole storeys is the last storey's. Error, with the limit: a setting out of
/// range, a plate larger than the lot, an inset that leaves nothing, a turned plate that leaves the lot, a
/// podium as high as the whole. Some 5 ms a plate.
Result<Massing> makeMassing(const Footprint& lot, const MassingSettings& settings);

/// Tiers made of plates, their figures worked out; for shapes that are not made from settings.
Massing parseMassing(const Footprint& lot, std::vector<Tier> tiers, double storeyHeightM);

/// A building of prisms that stand on z = 0, one part a piece of a tier; status "proposed". Error when a
/// prism is not a closed, outward oriented solid of the volume that it should have.
Result<Building> buildingOf(const Massing& massing, const std::string& id);

}  // namespace noonmark
