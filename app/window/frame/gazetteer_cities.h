#pragma once

#include "app/window/frame/zone_guess.h"

namespace noonmark {

/// Cities of 15,000 inhabitants and more, some 24,000 of them, from GeoNames; empty where the program was
/// built without libgeonames. Backend: gazetteer_cities_geonames.cpp.
std::vector<ZoneCity> gazetteerCities();

}  // namespace noonmark
