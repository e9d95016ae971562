#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/base/command_line.h"

namespace noonmark::cli::tests {

/// The exit code and output of a command line.
struct CommandOutput {
    int code = 0;
    std::string out;
    std::string err;

    [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// The words of a command with more options.
inline std::vector<std::string> plus(std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// Runs the program in this process, without a terminal.
inline CommandOutput noonmarkCli(const std::vector<std::string>& arguments) {
    std::vector<const char*> argv{"noonmark-cli"};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    std::ostringstream out;
    std::ostringstream err;
    const int code = runCommandLine(int(argv.size()), argv.data(), {out, err});
    return {code, out.str(), err.str()};
}

}  // namespace noonmark::cli::tests
