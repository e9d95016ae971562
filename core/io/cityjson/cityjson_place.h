#pragma once

#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geo/frame.h"
#include "core/io/cityjson/cityjson_model.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// Transforms the vertices of all blocks to local metres, in place, and removes objects farther than
/// `settings.farAwayM` from the middle of the data (the median of the objects), with a warning. Returns the
/// frame: the given one, or one with its origin in the middle of the remaining objects and z = 0 at the level
/// below which 5 % of the buildings begin (for terrain alone: its lowest point). Error: no coordinate
/// reference system, or coordinates that cannot belong to it; cancelled().
Result<Frame> placeCity(CityJsonData& data, const ReadSettings& settings, const std::string& file,
                        const std::stop_token& stop);

}  // namespace noonmark
