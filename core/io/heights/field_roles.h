#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/warnings.h"
#include "core/io/heights/height_facts.h"
#include "core/io/heights/name_words.h"
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
    topElevation,     ///< elevation of the roof, above the data's vertical datum
    bottomElevation,  ///< likewise of the underside: that of a passage, else the lowest ground
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

/// What a field's name says: its role, its priority, and the unit in its name.
struct FieldMeaning {
    FieldRole role = FieldRole::height;
    int rank = 0;  ///< of several fields of one role the lowest rank has priority
    /// From "height_ft" or "Height (m)", or of the dataset that uses this name
    std::optional<LengthUnit> unit;
    std::string_view meaning;   ///< "base of the roof"; empty: not stated
    std::string_view inFeetIn;  ///< the city whose field of this name is in feet; empty: none
    bool maybeInches = false;   ///< it ends in "in": inches, or a name cut off before its unit
};

/// The unit that the words of a name state.
std::optional<LengthUnit> unitOfWords(const NameWords& words);

/// Names are compared without case, blanks and punctuation, so "building:levels" equals "BUILDING_LEVELS".
/// `cutShort`: the format truncates names to ten letters (Shapefile), so that "ground_ele" is recognised too,
/// unless fields of several roles or units begin with these letters. Nothing for an unknown name. Names:
/// field_roles.h.
std::optional<FieldMeaning> findMeaning(std::string_view fieldName, bool cutShort = false);

/// The same for an OpenStreetMap tag. Few tags are heights or storeys there: "maxheight", for instance, is
/// the clearance under a bridge.
std::optional<FieldMeaning> findTagMeaning(std::string_view key);

/// Whether two names are equal apart from case, blanks and punctuation.
bool isSameField(std::string_view a, std::string_view b);

/// A field of a layer whose meaning is known.
struct KnownField {
    int index = 0;  ///< index in the layer
    std::string name;
    FieldMeaning meaning;
    LengthUnit unit = LengthUnit::metres;  ///< unit of numbers without a unit; see settleUnits
    std::string assumption = {};           ///< what was assumed of its values; empty: nothing
};

/// FieldMeaning::meaning of a height of the roof that stands for that of the building.
inline constexpr std::string_view heightOfRoof = "roof";

/// Field names chosen by the user, in any case; empty: found by name.
struct FieldChoice {
    std::string height;
    std::string levels;
    std::string name;
};

/// The known fields of a layer, best first within a role. A field that the user chose is the only one of its
/// role; as a height it is the elevation of the roof if its name says so. A name's meaning may depend on
/// other fields: next to other statistics of the roof, min_height is the lowest point of the roof and not an
/// underside; next to topheight, baseheight is the ground's elevation, and so is ground_height next to the
/// elevation of the roof, and an elevation of the underside where nothing else states the ground.
std::vector<KnownField> knownFields(const std::vector<std::string>& names, const FieldChoice& choice,
                                    bool cutShort);

/// Sources of the units of a layer's lengths, for values that state none.
struct UnitRules {
    std::optional<LengthUnit> stated;  ///< stated by the user: applies to every length
    bool mapInFeet = false;            ///< the map's coordinates are in feet
};

/// Decides every field's unit: the user's; else the one in its name or of its dataset; else feet for names
/// that some cities use in feet (New York's heightroof and groundelev), if both such fields are there or the
/// map is in feet; else metres. Assumptions are noted in the fields; addHeightFacts() warns of those that
/// mattered.
void settleUnits(std::vector<KnownField>& fields, const UnitRules& rules);

bool hasRole(const std::vector<KnownField>& fields, FieldRole role);

/// The HeightField of an `origin` (as in HeightReading::origin). Nothing if there is no field of that name.
std::optional<HeightField> findHeightField(const std::vector<KnownField>& fields, const std::string& origin);

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
