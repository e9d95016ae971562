#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/io/footprints/feature_facts.h"

namespace noonmark {

/// A feature with its shape in local metres.
struct PlacedFeature {
    FeatureFacts facts;
    std::vector<Footprint> pieces;  ///< at least one; disjoint
};

/// The features that make up one building, as indices.
struct BuildingGroup {
    std::optional<std::size_t> outline;
    std::vector<std::size_t> parts;  ///< may include the outline, if it is tagged as a part too
};

/// Groups features into buildings: features with the same stated building id; otherwise an outline with the
/// parts that it covers by more than half (if several outlines do, the one that covers most, then the smaller
/// one). Parts without an outline form one building if they overlap in plan. Every feature is in exactly one
/// group. Groups are in the order of their first feature.
std::vector<BuildingGroup> groupIntoBuildings(const std::vector<PlacedFeature>& features);

}  // namespace noonmark
