#pragma once

#include <string>
#include <vector>

#include "core/describe/field.h"

namespace noonmark {

/// An option of a command with its values; no values: a flag.
struct CommandOption {
    std::string name;
    std::vector<std::string> values;
    bool operator==(const CommandOption&) const = default;
};

/// The options that state these settings: those of fields that apply, have a flag, and differ from the
/// default or are always restated. A list of texts gives one option for each, as do named numbers.
std::vector<CommandOption> listOptions(const Described& settings);

}  // namespace noonmark
