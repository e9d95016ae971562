#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/warnings.h"
#include "core/io/heights/field_roles.h"
#include "core/io/heights/height_reading.h"

namespace noonmark {

/// Parses the `other_tags` column that converters of OpenStreetMap data write:
/// "height"=>"12","roof:shape"=>"flat"; inside the quotes a backslash escapes the next character. The list
/// ends at the first syntax error.
std::vector<std::pair<std::string, std::string>> parseTags(std::string_view text);

/// The attributes of a feature: everything except its shape.
struct FeatureFacts {
    std::string id;  ///< "way 34633854", "feature 12"
    std::string name;
    std::string status;
    std::string buildingId;  ///< features with the same id are one building; empty: not stated
    bool outline = true;     ///< it is the outline of a whole building
    bool part = false;       ///< it is a building:part; a feature may be both
    HeightReading heights;
    std::optional<bool> isOverhanging;  ///< if the file states it; otherwise settleParts decides
};

/// How to interpret the features of a layer.
struct LayerRules {
    HeightRules heights;
    bool tagged = false;  ///< OpenStreetMap tags: only features tagged building or building:part count
    bool sayNoBuilding =
        false;  ///< warn about features without such a tag (in a file that should hold buildings only)
};

/// Nothing for a feature that is not a building (tagged no, or without a building tag) or is underground:
/// location=underground, or a level below 0, a layer below -1 or tunnel=yes unless a height, storeys, an
/// entrance or a location says otherwise. That contradiction gives a warning, and so does layer=-1, which
/// alone does not mean underground, and a roof that is not flat (drawn flat at full height).
std::optional<FeatureFacts> collectFacts(const FeatureValues& values, const LayerRules& rules, std::string id,
                                         Warnings& warnings);

}  // namespace noonmark
