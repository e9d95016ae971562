#pragma once

#include <optional>
#include <string>

#include "core/base/warnings.h"
#include "core/io/footprints/feature_value.h"
#include "core/io/heights/height_reading.h"

namespace noonmark {

/// What a feature is and how high, apart from its shape.
struct FeatureFacts {
    std::string id;  ///< "way 34633854", "feature 12"
    std::string name;
    std::string status;
    std::string buildingId;  ///< features with the same one are one building; empty: not stated
    bool outline = true;     ///< the outline of a whole building
    bool part = false;       ///< building:part; a feature may be both
    HeightReading heights;
    std::optional<bool> isOverhanging;  ///< where the file says it; else it is found by what is below
};

/// How the features of a layer are to be understood.
struct LayerRules {
    HeightRules heights;
    bool tagged = false;  ///< OpenStreetMap tags: only what is tagged building or building:part counts
    bool sayNoBuilding =
        false;  ///< warn of features without such a tag (a file of buildings should have none)
};

/// Nothing for what is no building (no, or not tagged so) or lies underground: location=underground; a layer
/// or level below 0 or tunnel=yes where neither a height, storeys, an entrance nor a location say otherwise.
/// The latter is a warning, as are tags that contradict each other so, and a roof that is not flat (drawn
/// flat at full height).
std::optional<FeatureFacts> collectFacts(const FeatureValues& values, const LayerRules& rules, std::string id,
                                         Warnings& warnings);

}  // namespace noonmark
