#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/io/footprints/feature_value.h"

namespace noonmark {

/// A field name of a published dataset of buildings, and what it holds there.
struct FieldName {
    std::string_view name;  ///< lower-case letters and digits only: "buildinglevels"
    /// Nothing: it looks like one of the others and is something else. It keeps a name cut short from being
    /// taken for it.
    std::optional<FieldRole> role;
    std::string_view meaning;        ///< of a height: the part of the building that it reaches; may be empty
    std::optional<LengthUnit> unit;  ///< where the dataset states it once and for all
    /// A city that keeps a field of this name in feet, where others have metres: not taken silently.
    std::string_view inFeetIn;
};

/// All of them. Of several fields of one role in a file the first in this list is asked first: a typical
/// height of the roof before its base, and both before its highest point.
std::span<const FieldName> listFieldNames();

}  // namespace noonmark
