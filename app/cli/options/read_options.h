#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/io/read_city.h"

namespace noonmark::cli {

/// The files of a command and how to read them; shared by all commands that read a city.
struct ReadOptions {
    std::vector<std::string> files;
    std::string filesHelp = "City files, or sample:central-park-south, sample:grid";
    ReadSettings settings;
};

/// Adds FILE... and one option per user-visible field of ReadSettings. `options` must outlive the parsing.
void addReadOptions(CLI::App& command, ReadOptions& options);

}  // namespace noonmark::cli
