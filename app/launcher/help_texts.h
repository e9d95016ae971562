#pragma once

#include <span>
#include <string_view>

namespace noonmark::launcher {

/// What one command prints when it is asked for help.
struct HelpText {
    std::string_view words;  ///< of the command, after the program's name: "project new"; empty: the program
    std::string_view text;
};

/// The help of all commands. The source is written by noonmark-commands when the programs are built, so that
/// no option is described twice (app/cli/describe).
std::span<const HelpText> helpTexts();

}  // namespace noonmark::launcher
