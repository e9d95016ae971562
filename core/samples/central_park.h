#pragma once

#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/geo/frame.h"
#include "core/samples/street_axes.h"

namespace noonmark {

/// The streets around Central Park's southern end as an ideal grid: widths and distances of the
/// Commissioners' Plan of 1811, in street axes from the park's south-eastern corner. Accurate to some 15 m.
enum class Avenue { tenth, ninth, eighth, seventh, sixth, fifth, madison, park, lexington, third };

/// The frame; its origin is the origin of the axes: the park's corner at Grand Army Plaza.
Frame centralParkFrame();

double westSideOf(Avenue avenue);
double eastSideOf(Avenue avenue);
/// Numbered streets; 57th, 59th and 72nd are wide.
double southSideOf(int street);
double northSideOf(int street);

/// The block east of an avenue and north of a street.
StreetBox blockAt(Avenue avenue, int street);

/// Eighth Avenue to Fifth Avenue, 59th to 72nd Street.
StreetBox parkBox();

/// Broadway south and north of Columbus Circle.
SkewedAvenue broadwaySouth();
SkewedAvenue broadwayNorth();
StreetBox columbusCircle();

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
