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

/// The features that make one building, as indices.
struct BuildingGroup {
    std::optional<std::size_t> outline;
    std::vector<std::size_t> parts;  ///< may hold the outline too, where it is tagged as a part itself
};

/// Which features make one building: those with the same stated building id; else an outline with the parts
/// of which it covers more than half (of several such outlines the one that covers most, then the smaller
/// one). Parts without an outline make one building where they stand over one another. Every feature is in
/// just one group. Groups are in the order of their first feature.
std::vector<BuildingGroup> groupIntoBuildings(const std::vector<PlacedFeature>& features);

}  // namespace noonmark
