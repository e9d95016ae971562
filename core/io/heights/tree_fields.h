#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/trees/tree_facts.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// What a field of an inventory of trees holds.
enum class TreeRole {
    height,
    crownDiameter,
    crownBase,
    stemDiameter,
    stemGirth,  ///< pi times the diameter
    genus,
    species,     ///< a whole name, "Latin :: common" too
    epithet,     ///< the second word of a name: follows the genus
    leafCycle,   ///< "evergreen", "deciduous"
    leafType,    ///< "needleleaved", "broadleaved"
    leafOnDay,   ///< first day in leaf: "04-15"
    leafOffDay,  ///< first day without leaves
    status,      ///< "Alive", "Stump"
    planted,     ///< year of planting or age: no size, which a warning says
    longitude,
    latitude,
    latLon,    ///< both in one field, latitude first: "48.85, 2.35"
    easting,   ///< in the file's system, or degrees
    northing,  ///< likewise
};

/// A role that a user may state a field for.
struct TreeRoleEntry {
    TreeRole role;
    std::string_view key;    ///< as options take it: "stem"
    std::string_view label;  ///< translatable
    bool isLength = false;   ///< its numbers have a unit
};
std::span<const TreeRoleEntry> listTreeRoles();

/// What a user states of an inventory in place of what the names of its fields say.
struct TreeFieldChoice {
    TreeRole role = TreeRole::height;
    std::string field;                              ///< empty: none has this role
    std::optional<LengthUnit> unit = std::nullopt;  ///< of numbers; nothing: as the name says, else metres
};
using TreeFieldChoices = std::vector<TreeFieldChoice>;

/// "height=HOEHE", "stem=DBH:in", "height=" for none. Error: neither; an unknown role or unit, which lists
/// them.
Result<TreeFieldChoice> parseTreeFieldChoice(std::string_view text);

/// A field name that published inventories use.
struct TreeFieldName {
    std::string_view name;  ///< lower-case letters and digits only: "treedbh"
    TreeRole role;
    LengthUnit unit = LengthUnit::metres;  ///< of numbers without one
    /// The entry holds only where the layer has this field too: a city whose field of a common name is in
    /// another unit. Empty: always.
    std::string_view besides = {};
    std::span<const double> classes = {};  ///< metres in the middle of class 0, 1, 2, ...: values are classes
    bool unsure = false;                   ///< the unit is an assumption, which a warning states
};

/// All of them; where a layer has several of one role, the first in this list counts.
std::span<const TreeFieldName> listTreeFieldNames();

/// A field of a layer with its meaning.
struct KnownTreeField {
    std::string field;      ///< its name in the file
    std::size_t index = 0;  ///< among the names given
    TreeFieldName meaning;
};

/// The fields that are known, one of each role; those that the user chose first. Names of ten letters may be
/// the beginning of a listed one: Shapefiles cut them there.
std::vector<KnownTreeField> findTreeFields(std::span<const std::string> names,
                                           const TreeFieldChoices& choices = {});

/// The field of a role; null: none.
const KnownTreeField* findRole(std::span<const KnownTreeField> fields, TreeRole role);

/// The facts of a tree in its values, which stand as the names given to findTreeFields(). What cannot be read
/// or is not plausible is left out, with a warning at `where`; so is zero, which many write for unknown.
TreeFacts collectTreeFacts(std::span<const KnownTreeField> fields, std::span<const std::string> values,
                           const std::string& where, Warnings& warnings);

/// Whether the values say that no tree stands there: a stump, an empty pit, a dead, felled or planned tree.
bool saysNoTree(std::span<const KnownTreeField> fields, std::span<const std::string> values);

/// Metres of a height or width as inventories write it: "12.5", "40 ft", a class "6-10 m" (its middle), "> 35
/// m" (its limit). Nothing for other texts.
std::optional<double> parseTreeLength(std::string_view text, LengthUnit bareUnit);

}  // namespace noonmark
