#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/read_city.h"

namespace noonmark {

/// What a field of a footprint file means to us.
enum class FieldRole {
    height,
    levels,
    minHeight,
    minLevel,
    roofHeight,
    roofLevels,
    roofShape,
    groundElevation,
    topElevation,  ///< of the roof, above the data's vertical datum
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

/// One filled-in field of one feature. Blank and null fields have none.
struct FeatureValue {
    FieldRole role = FieldRole::height;
    std::string field;                     ///< its name in the file, for warnings
    std::string text;                      ///< as written; a number field's value in decimal
    std::optional<double> number;          ///< of number fields
    LengthUnit unit = LengthUnit::metres;  ///< of a length without a unit of its own
};

/// All that is known of one feature; of one role the better field comes first.
using FeatureValues = std::vector<FeatureValue>;

/// The first value of a role, or null.
const FeatureValue* firstOf(const FeatureValues& values, FieldRole role);

}  // namespace noonmark
