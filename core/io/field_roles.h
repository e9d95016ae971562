#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/feature_value.h"
#include "core/warnings.h"

namespace noonmark {

/// What a field's name says: its role, how good a source it is, and the unit in its name.
struct FieldMeaning {
    FieldRole role = FieldRole::height;
    int rank = 0;                    ///< of several fields of one role the lowest is asked first
    std::optional<LengthUnit> unit;  ///< "height_ft", "Height (m)"
    bool newYork = false;  ///< heightroof, groundelev: the names of New York's footprints, which are in feet
};

/// Names are compared without case, blanks and punctuation, so "building:levels" is "BUILDING_LEVELS".
/// `cutShort`: the format keeps ten letters of a name (Shapefile), so "ground_ele" is known too; a beginning
/// that several roles share is not. Nothing for a name that means nothing to us.
std::optional<FieldMeaning> meaningOf(std::string_view fieldName, bool cutShort = false);

/// A field of a layer that means something.
struct KnownField {
    int index = 0;  ///< in the layer
    std::string name;
    FieldMeaning meaning;
    LengthUnit unit = LengthUnit::metres;  ///< of its bare numbers; see settleUnits
};

/// The known fields of a layer, best first within a role. `heightField`: the user's own choice (any case); it
/// alone is the height then.
std::vector<KnownField> knownFields(const std::vector<std::string>& names, const std::string& heightField,
                                    bool cutShort);

/// What the units of a layer's lengths are, where the values do not say it themselves.
struct UnitRules {
    std::optional<LengthUnit> stated;  ///< by the user: holds for every length
    bool mapInFeet = false;            ///< the map's coordinates are in feet
};

/// Decides every field's unit: the user's; else the one in its name; else feet for New York's heightroof and
/// groundelev, where both are there or the map is in feet; else metres. Says what it assumed. `where`: the
/// layer, for warnings.
void settleUnits(std::vector<KnownField>& fields, const UnitRules& rules, const std::string& where,
                 Warnings& warnings);

bool hasRole(const std::vector<KnownField>& fields, FieldRole role);

}  // namespace noonmark
