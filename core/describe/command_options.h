#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/describe/field.h"

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
