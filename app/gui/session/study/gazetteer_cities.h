#pragma once

#include "app/gui/session/study/zone_guess.h"

namespace noonmark {

/// Cities with 15,000 or more inhabitants, about 24,000 of them, from GeoNames. Empty if the program was
/// built without libgeonames. Backend: gazetteer_cities_geonames.cpp.
std::vector<ZoneCity> gazetteerCities();

}  // namespace noonmark
