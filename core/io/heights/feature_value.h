#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/settings/read_settings.h"

namespace noonmark {

/// The role of a field of a footprint file.
enum class FieldRole {
    height,
    levels,
    minHeight,
    minLevel,
    roofHeight,
    roofLevels,
    roofShape,
    groundElevation,
    topElevation,  ///< elevation of the roof, above the data's vertical datum
    building,
    buildingPart,
    location,
    layer,
    level,
    tunnel,
    entrance,
    underground,
    id,
    buildingId,
    name,
    status,
    heightSource,
    isOverhanging,
};

/// One field of one feature that has a value. Blank and null fields are omitted.
struct FeatureValue {
    FieldRole role = FieldRole::height;
    std::string field;                     ///< the field's name in the file, for warnings
    std::string text;                      ///< the value as written; for a number field, in decimal
    std::optional<double> number;          ///< for number fields
    LengthUnit unit = LengthUnit::metres;  ///< unit of a length that states none
};

/// All known fields of one feature; of several with one role the better field comes first.
using FeatureValues = std::vector<FeatureValue>;

/// The first value of a role, or null.
const FeatureValue* firstOf(const FeatureValues& values, FieldRole role);

}  // namespace noonmark
