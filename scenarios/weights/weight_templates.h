#pragma once

#include "scenarios/weights/time_weights.h"

namespace noonmark {

// Tables to begin with. Which months and hours they name is a rule of thumb of Noonmark's own by latitude,
// degrees, negative in the south, where the seasons are half a year later; it knows no local climate. Hours
// are wall clock.

/// For people who walk and sit outside: shade is wanted at midday and in the afternoon of the hot months, sun
/// in winter; within the tropics shade all year. From 55 degrees only July (January) is hot. Its name is
/// "pedestrian comfort".
TimeWeights makeComfortWeights(double latitudeDeg);

/// For plants: sun is wanted all day (6:00 to 20:00) in the growing season, which is shorter the farther from
/// the equator; all year within the tropics. Its name is "plants".
TimeWeights makePlantWeights(double latitudeDeg);

}  // namespace noonmark
