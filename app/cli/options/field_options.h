#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "core/describe/command_options.h"

namespace noonmark::cli {

/// How a command takes the options of a table of fields.
struct FieldOptions {
    FlagNames names{};  ///< one flag may have several, with commas
    /// Receives the flags of the table that the user gave; it outlives the parsing.
    std::set<std::string, std::less<>>* given = nullptr;
    /// Lists of numbers may be written with blanks, too: "--threshold 30 60", as commands of earlier versions
    /// state them. What follows such a list must then be an option.
    bool listsTakeBlanks = false;
};

/// Adds an option for each field that has a flag: its help, range, choices and default are those of the
/// table. What is read goes into the object, which must outlive the parsing. A list of texts may be given
/// several times.
void addFieldOptions(CLI::App& command, const Editable& settings, const FieldOptions& options = {});

}  // namespace noonmark::cli
