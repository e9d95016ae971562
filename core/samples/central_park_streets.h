#pragma once

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

}  // namespace noonmark
