#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/cli/options/study_options.h"

namespace noonmark::cli {

/// The options of a parsed command that were given, as words that parse to the same values; without files and
/// without the options in `leaveOut`.
std::vector<std::string> listArguments(const CLI::App& command, const std::vector<std::string>& leaveOut);

/// What a study of given options reads and asks.
struct StudyArguments {
    ReadSettings reading;
    StudySettings settings;  ///< without region
};

/// Error: words of another version of the program, or a period out of range.
Result<StudyArguments> parseArguments(const std::vector<std::string>& arguments);

}  // namespace noonmark::cli
