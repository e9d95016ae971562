#pragma once

#include "core/geo/frame.h"
#include "core/io/cityjson/cityjson_model.h"
#include "core/io/read_city.h"

namespace noonmark {

/// Puts the vertices of all blocks into local metres, in place, and takes objects out that lie further than
/// `settings.farAwayM` from the middle of the data (the median of the objects), with a warning. Returns the
/// frame: the one given, or one with its origin in the middle of what is left and its z = 0 at the level that
/// 5 % of the buildings begin below (of the terrain, its lowest). Error: no coordinate reference system, or
/// coordinates that cannot be of it.
Result<Frame> placeCity(CityJsonData& data, const ReadSettings& settings, const std::string& file);

}  // namespace noonmark
