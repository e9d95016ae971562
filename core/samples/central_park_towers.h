#pragma once

#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/samples/street_axes.h"

namespace noonmark {

/// A named tower with its published dimensions, and whether it had been built in the paper's year, 2017.
struct NamedTower {
    std::string name;
    std::string status;  ///< "built" or "to be built"
    LonLat place;        ///< published position, accurate to some 20 m
    double heightM = 0;  ///< height of the roof, without spires
    StreetBox floor;     ///< the floor plate along the streets, moved from `place` onto its block
};

/// The seven towers of the case study (paper, section 8.1: "between 780 ft. and 1,490 ft."). Roof heights are
/// those of the Council on Tall Buildings and Urban Habitat; floor plates are accurate to a few metres.
/// Central Park Tower has the 472.4 m (1,550 ft) that were built; the plans of the paper's time had a roof
/// some 20 m lower.
std::vector<NamedTower> caseStudyTowers();

/// Time Warner Center, the paper's baseline: two towers on a podium.
std::vector<NamedTower> timeWarnerTowers();
StreetBox timeWarnerPodium();
constexpr double timeWarnerPodiumM = 50;

}  // namespace noonmark
