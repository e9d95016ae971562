#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/describe/field.h"

namespace noonmark::flags {

/// Flags of noonmark-cli that no table of fields has, and that repeat commands or messages name all the same.

inline constexpr const char* out = "--out";
inline constexpr const char* overwrite = "--overwrite";
inline constexpr const char* json = "--json";
inline constexpr const char* save = "--save";
inline constexpr const char* keep = "--keep";
inline constexpr const char* scenario = "--scenario";
inline constexpr const char* baseline = "--baseline";
inline constexpr const char* from = "--from";  ///< scenario that another is compared with
inline constexpr const char* to = "--to";
inline constexpr const char* places = "--places";
inline constexpr const char* rule = "--rule";
inline constexpr const char* rules = "--rules";  ///< folder of the user's own rules
inline constexpr const char* choose = "--choose";
inline constexpr const char* year = "--year";
inline constexpr const char* tile = "--tile";
inline constexpr const char* partial = "--partial";
inline constexpr const char* threshold =
    "--threshold";  ///< of a change, minutes a day; of colours of places, hours
inline constexpr const char* byBuilding = "--by-building";
inline constexpr const char* weights = "--weights";  ///< table of a score

}  // namespace noonmark::flags

namespace noonmark {

/// An option of a command with its values; no values: a flag.
struct CommandOption {
    std::string name;
    std::vector<std::string> values;
    bool operator==(const CommandOption&) const = default;
};

/// Names of flags on a command that differ from those of a table: {"--from", "--at"}.
using FlagNames = std::map<std::string_view, std::string>;

/// The options that state these settings: those of fields that apply, have a flag, and differ from the
/// default or are always restated. A list of texts gives one option for each, as do named numbers.
std::vector<CommandOption> listOptions(const Described& settings, const FlagNames& names = {});

/// The flag of the field with this key, which the table has.
std::string_view flagOf(std::span<const Field> fields, std::string_view key);

/// Whether a table has a field with this flag.
bool hasFlag(std::span<const Field> fields, std::string_view flag);

}  // namespace noonmark
