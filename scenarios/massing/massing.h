#pragma once

// The folder scenarios/massing/ builds towers on lots. This file makes one from a user's settings;
// fit_floor_area.h finds settings for a floor area and those nearest to impossible ones. floor_plate.h
// computes the plates with straight_skeleton.h (backend CGAL), the walls of tapered and twisted volumes and
// the floor area of each use. copy_massing.h reshapes a building at constant gross floor area; lot_edits.h
// turns massings into edits of a city, and tower_design.h finds the massing of a scenario's towers again.

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/building_heights.h"
#include "core/city/city.h"

namespace noonmark {

inline constexpr int maxStoreys = 500;  ///< of a designed building

/// Size of a floor plate: a share of the lot or an area. With neither, the plate is the whole lot.
struct PlateSize {
    std::optional<double> shareOfLot;  ///< more than 0, at most 1
    std::optional<double> areaM2;      ///< more than 0, at most the lot's area
    bool operator==(const PlateSize&) const = default;
};

/// How the walls of one volume lean. From its lowest plate to its top, the plate shrinks and turns about the
/// centroid of the lowest plate, in proportion to the height.
struct WallShape {
    double taper = 0;     ///< share of its width and depth that the plate has lost at the top: 0 to 0.95
    double twistDeg = 0;  ///< clockwise, from the bottom to the top: -360 to 360
    [[nodiscard]] bool upright() const { return taper == 0 && twistDeg == 0; }
    bool operator==(const WallShape&) const = default;
};

/// Above `aboveM` the walls are inset by `insetM`, measured from the top of the volume below.
struct Setback {
    double aboveM = 0;  ///< above the ground; less than the tower's height
    double insetM = 0;  ///< more than 0, perpendicular to every wall, courtyard walls included
    WallShape walls{};  ///< of the volume above the setback
    bool operator==(const Setback&) const = default;
};

struct Podium {
    int storeys = 1;  ///< fewer than the whole building has
    PlateSize plate;
    WallShape walls{};
    bool operator==(const Podium&) const = default;
};

/// What some storeys of a tower are used for. Uses are stacked from the ground floor up.
struct FloorUse {
    std::string use;  ///< "offices": free text, 1 to 60 bytes
    int storeys = 0;  ///< 1 to 500; 0: all storeys above, allowed in the last one only
    bool operator==(const FloorUse&) const = default;
};

/// Another tower on the same lot, which stands apart from the first.
struct FurtherTower {
    int storeys = 10;  ///< 1 to 500, of the first one's storey height
    PlateSize plate;   ///< with neither, its whole piece of the lot
    bool operator==(const FurtherTower&) const = default;
};

/// User settings for a tower on a lot, or for several: then the lot is divided across its longest side into
/// pieces of equal width, one for each tower, in the order from the beginning of that side.
struct MassingSettings {
    double storeyHeightM = defaultStoreyM;  ///< 2 to 10
    int storeys = 0;     ///< in total, podium included: 1 to maxStoreys; 0: as many as fit into heightM
    double heightM = 0;  ///< 0: storeys x storey height; else 2 to 2000
    PlateSize plate;     ///< of the tower at its base
    std::optional<Podium> podium;
    std::vector<Setback> setbacks;  ///< from bottom to top
    double clockwiseDeg = 0;  ///< turns the tower about the centroid of its plate; it must stay on the lot
    WallShape walls{};        ///< of the volume between podium and lowest setback
    std::vector<FloorUse> uses{};  ///< of the first tower, from bottom to top; empty: not stated
    std::vector<FurtherTower> further{};
    double gapM = 12;  ///< between two pieces of the lot: 1 to 500
    bool operator==(const MassingSettings&) const = default;
};

/// The tower's height, metres: as stated, or storeys x storey height.
double heightOf(const MassingSettings& settings);

/// The same settings with another height. A whole number of storeys is stated as such.
MassingSettings withHeight(MassingSettings settings, double heightM);

/// One volume of a massing. Its plate has several pieces where insets split it.
struct Tier {
    std::vector<Footprint> plate;  ///< at its bottom
    double bottomM = 0;            ///< above the ground
    double topM = 0;
    int storeys = 0;    ///< number of floors in it
    double areaM2 = 0;  ///< of its plate
    WallShape walls{};
};

/// The storeys of a tower that have one use.
struct UseArea {
    std::string use;  ///< empty: storeys for which no use is stated
    int storeys = 0;  ///< 0: the tower ends below them
    double grossFloorM2 = 0;
    bool operator==(const UseArea&) const = default;
};

struct MassingFigures {
    double lotM2 = 0;
    double grossFloorM2 = 0;    ///< sum of the sections at the storeys' floors
    double floorAreaRatio = 0;  ///< gross floor area / lot
    double coverage = 0;        ///< share of the lot that is covered
    double heightM = 0;
    int storeys = 0;
    std::vector<UseArea> uses{};  ///< from bottom to top; empty: no use is stated
};

struct Massing {
    /// Of each tower from bottom to top, where each one's plate lies on the top of the one below.
    std::vector<Tier> tiers;
    std::size_t firstTiers = 0;  ///< those of the first tower, before those of further ones
    double storeyHeightM = 0;
    std::vector<double> storeyM2{};  ///< section at the floor of each storey, from the ground floor up
    MassingFigures figures;
};

/// Extrudes a tower on a lot, or several. A plate smaller than the lot is the straight-skeleton inset of the
/// lot with that area: it keeps the lot's shape and enlarges its courtyards. A floor belongs to the tier that
/// contains its level; height left over after whole storeys goes to the last storey. Error, with the limit: a
/// setting out of range, a plate larger than the lot, an inset that leaves nothing, a turned plate that
/// leaves the lot, a twisted volume that leaves the lot, a podium as high as the whole building, or a lot too
/// narrow for so many towers. About 5 ms per plate.
Result<Massing> makeMassing(const Footprint& lot, const MassingSettings& settings);

/// Builds a massing from given tiers and computes its figures, for shapes that do not come from settings.
Massing assembleMassing(const Footprint& lot, std::vector<Tier> tiers, double storeyHeightM);

/// A building on z = 0 with status "proposed", one part per piece of a tier: a prism, or a mesh where its
/// walls lean (floor_plate.h); a twisted one counts as an overhang. Error: a part is not a closed,
/// outward-oriented solid of the expected volume.
Result<Building> buildingOf(const Massing& massing, const std::string& id);

}  // namespace noonmark
