#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "core/describe/field.h"

namespace noonmark::cli {

/// How a command takes the options of a table of fields.
struct FieldOptions {
    /// Names of flags on this command that differ from those of the table: {"--from", "--at"}, several with
    /// commas.
    std::map<std::string_view, std::string> names{};
    /// Receives the flags of the table that the user gave; it outlives the parsing.
    std::set<std::string, std::less<>>* given = nullptr;
};

/// Adds an option for each field that has a flag: its help, range, choices and default are those of the
/// table. What is read goes into the object, which must outlive the parsing. A list of texts may be given
/// several times.
void addFieldOptions(CLI::App& command, const Editable& settings, const FieldOptions& options = {});

}  // namespace noonmark::cli
