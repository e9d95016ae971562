#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/io/heights/field_roles.h"

namespace noonmark {

/// A field name that published datasets of buildings use, and its meaning there.
struct FieldName {
    std::string_view name;  ///< lower-case letters and digits only: "buildinglevels"
    /// Nothing: the name looks like one of the others but means something else. Such an entry prevents a
    /// truncated name from being mistaken for another.
    std::optional<FieldRole> role;
    std::string_view meaning;  ///< for a height: the part of the building that it refers to; may be empty
    std::optional<LengthUnit> unit;  ///< if the dataset fixes it
    /// A city whose field of this name is in feet, while others use metres: the program does not assume a
    /// unit silently.
    std::string_view inFeetIn;
};

/// All field names. If a file has several fields of one role, the first in this list has priority: a typical
/// height of the roof before its base, and both before its highest point.
std::span<const FieldName> listFieldNames();

}  // namespace noonmark
