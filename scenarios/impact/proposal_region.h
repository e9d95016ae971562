#pragma once

// Whether a proposal stands where shadow is measured, and a region that holds it.

#include <memory>
#include <optional>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/receivers/receivers.h"

namespace noonmark {

struct ImpactAnswer;

enum class InRegion { whole, part, none };

/// How much of a building's ground, by its bounding box, is in the region; of several: `whole` if all are,
/// `none` if no part of any is. None at all: whole.
InRegion findInRegion(const std::vector<std::shared_ptr<const Building>>& buildings, const Region& region);

/// A box as large as the region, around the buildings; larger where these and 50 m around them need it.
/// Outside the tropics it lies further towards the pole, where their shadows fall. `buildings`: at least one.
Region makeRegionAround(const std::vector<std::shared_ptr<const Building>>& buildings, const Region& region,
                        double latDeg);

/// What a comparison leaves out.
struct BeyondRegion {
    InRegion proposal = InRegion::whole;
    bool changesAtEdge = false;  ///< by more than the first threshold beside the edge, and probably beyond
};
/// O(cells), unless the answer holds it.
BeyondRegion findBeyond(const ImpactAnswer& answer);
/// The same as a sentence; none: nothing is known to be left out.
std::optional<Sentence> describeBeyond(const ImpactAnswer& answer);

}  // namespace noonmark
