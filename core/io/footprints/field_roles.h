#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/warnings.h"
#include "core/io/footprints/feature_value.h"

namespace noonmark {

/// What a field's name says: its role, how good a source it is, and the unit in its name.
struct FieldMeaning {
    FieldRole role = FieldRole::height;
    int rank = 0;                    ///< of several fields of one role the lowest is asked first
    std::optional<LengthUnit> unit;  ///< "height_ft", "Height (m)", or of the dataset that has this name
    std::string_view meaning;        ///< "base of the roof"; empty: not stated
    std::string_view inFeetIn;       ///< the city that keeps a field of this name in feet; empty: none
};

/// Names are compared without case, blanks and punctuation, so "building:levels" is "BUILDING_LEVELS".
/// `cutShort`: the format keeps ten letters of a name (Shapefile), so "ground_ele" is known too; a beginning
/// that fields of several roles or units share is not. Nothing for a name that means nothing to us. Names:
/// field_names.h.
std::optional<FieldMeaning> findMeaning(std::string_view fieldName, bool cutShort = false);

/// The same of a tag of OpenStreetMap, whose heights and storeys have few names: "maxheight" is what fits
/// under a bridge.
std::optional<FieldMeaning> findTagMeaning(std::string_view key);

/// Whether two names are the same but for case, blanks and punctuation.
bool isSameField(std::string_view a, std::string_view b);

/// A field of a layer that means something.
struct KnownField {
    int index = 0;  ///< in the layer
    std::string name;
    FieldMeaning meaning;
    LengthUnit unit = LengthUnit::metres;  ///< of its bare numbers; see settleUnits
};

/// The user's own choice, any case; empty: found by the name.
struct FieldChoice {
    std::string height;
    std::string levels;
};

/// The known fields of a layer, best first within a role. A chosen field is the only one of its role; as a
/// height it may be the roof's elevation where its name says so and the ground's is there too. What a name
/// means may depend on its neighbours: next to other statistics of the roof, min_height is the lowest roof
/// and no underside; next to topheight, baseheight is the ground's elevation; and a roof's elevation without
/// the ground's is left out.
std::vector<KnownField> knownFields(const std::vector<std::string>& names, const FieldChoice& choice,
                                    bool cutShort);

/// What the units of a layer's lengths are, where the values do not say it themselves.
struct UnitRules {
    std::optional<LengthUnit> stated;  ///< by the user: holds for every length
    bool mapInFeet = false;            ///< the map's coordinates are in feet
};

/// Decides every field's unit: the user's; else the one in its name or of its dataset; else feet for the
/// names of cities that keep them so (New York's heightroof and groundelev), where both are there or the map
/// is in feet; else metres. Says what it assumed. `where`: the layer, for warnings.
void settleUnits(std::vector<KnownField>& fields, const UnitRules& rules, const std::string& where,
                 Warnings& warnings);

bool hasRole(const std::vector<KnownField>& fields, FieldRole role);

/// The fact to state of a field: `origin` as HeightReading::origin has it. None: no field of that name.
std::optional<HeightField> findHeightField(const std::vector<KnownField>& fields, const std::string& origin);

}  // namespace noonmark
