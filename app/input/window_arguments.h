#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace noonmark {

/// The command line of the window's program, which noonmark-cli describes too (app/cli/describe).
struct WindowArguments {
    std::vector<std::string> files;
};

/// Names and describes the program and adds its arguments, which are parsed into `arguments`; it must live as
/// long as the parser is used.
void addWindowArguments(CLI::App& program, WindowArguments& arguments);

}  // namespace noonmark
