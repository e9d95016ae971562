#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/io/terrain/ground_choice.h"

namespace noonmark {

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
