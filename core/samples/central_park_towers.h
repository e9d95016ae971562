#pragma once

#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/samples/street_axes.h"

namespace noonmark {

/// A tower that has a name: public figures, and whether it stood in the paper's year, 2017.
struct NamedTower {
    std::string name;
    std::string status;  ///< "built" or "to be built"
    LonLat place;        ///< public, to some 20 m
    double heightM = 0;  ///< of the roof, without spires
    StreetBox floor;     ///< the floor plate along the streets, moved from `place` onto its block
};

/// The seven towers of the case study (paper, section 8.1: "between 780 ft. and 1,490 ft."). Roof heights as
/// the Council on Tall Buildings and Urban Habitat lists them; floor plates to a few metres. Central Park
/// Tower has the 472.4 m (1,550 ft) that were built; the plans of the paper's time had a roof some 20 m
/// lower.
std::vector<NamedTower> caseStudyTowers();

/// Time Warner Center, the paper's baseline: two towers on a podium.
std::vector<NamedTower> timeWarnerTowers();
StreetBox timeWarnerPodium();
constexpr double timeWarnerPodiumM = 50;

}  // namespace noonmark
