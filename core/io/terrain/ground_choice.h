#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/io/pieces/read_part.h"

namespace noonmark {

/// A file of a city after reading.
struct GroundFile {
    std::string name;
    FilePiece* piece;       ///< its buildings may get heights
    bool isRaster = false;  ///< its terrain may be a model of the surface
};

/// The terrain of a city.
struct GroundChoice {
    std::shared_ptr<const Terrain> terrain;  ///< null: no file has one
    Warnings warnings;
};

/// Chooses the terrain: the first that shows the ground. Without one, the ground around the outlines of a
/// surface model (surface_model.h). If the settings ask for it, buildings without a height get that of the
/// surface model, and its field is added to `heights`. Ends early when stopped.
GroundChoice chooseGround(const std::vector<GroundFile>& files, const ReadSettings& settings,
                          HeightFacts& heights, const std::stop_token& stop);

}  // namespace noonmark
