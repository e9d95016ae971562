#pragma once

#include <functional>
#include <memory>
#include <optional>
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

/// Whether a part of the building has an assumed height.
bool hasAssumedHeight(const Building& building);

/// A building whose assumed heights are replaced by `heightOf(part)` above its base; null if none is: where
/// it is nothing, or less than 1 m above the part's underside.
std::shared_ptr<const Building> withHeights(const Building& building,
                                            const std::function<std::optional<float>(const Part&)>& heightOf);

/// Gives buildings of which only the elevation of the roof is known (FilePiece::roofs) their height above the
/// terrain, and adds the fields to `heights`. Without a terrain the heights stay assumed, or count from 0 if
/// the user chose the field (`chosen`): a warning says which.
void measureRoofs(const GroundFile& file, const Terrain* terrain, const Frame& frame, bool chosen,
                  HeightFacts& heights);

/// After parts with assumed heights got others: takes back what was said of those, by part, and of the fields
/// that could hold heights if none is left.
void withdrawAssumed(const GroundFile& file);

}  // namespace noonmark
