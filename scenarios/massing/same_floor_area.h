#pragma once

#include <limits>

#include "scenarios/massing/floor_plate.h"

namespace noonmark {

/// What a massing of another shape has to keep.
struct GivenMass {
    Plate plate;              ///< what touches the ground
    double grossFloorM2 = 0;  ///< the area to keep
    double storeyHeightM = 3.5;
    int estimatedStoreys =
        0;  ///< of an open mesh, whose floors are estimated (core/city/meshes/mesh_section.h)
};

GivenMass givenBy(const Massing& massing);

/// A building that is there, cut into storeys of `storeyHeightM` (2 to 10) from `groundM` (local z) up
/// (core/city/footprints/floor_area.h). Error where it has not one storey.
Result<GivenMass> givenBy(const Building& building, double groundM, double storeyHeightM);

/// The plate factor that means "the largest that the lot allows".
inline constexpr double largestPlate = std::numeric_limits<double>::infinity();

/// One tower of the same gross floor area (to 0.1 %) on a plate `plateFactor` times as large: above 1
/// shorter and wider, below 1 slimmer and taller (paper, section 8.1: "we doubled the floor plate size. For
/// others, we used the largest floor plate size that could be accommodated"). A wider plate keeps its shape
/// and middle, cut by the lot; where the lot does not hold it, it is the whole lot. The plate is then made a
/// little smaller or larger so that the storeys are whole. Error: a factor that is not over 0, a plate that
/// is not on the lot, or more than 500 storeys or 2000 m, with the slimmest that can be.
Result<Massing> findSameFloorArea(const Footprint& lot, const GivenMass& given, double plateFactor);

}  // namespace noonmark
