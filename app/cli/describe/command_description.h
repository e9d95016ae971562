#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace noonmark::cli {

/// What an option or a positional argument takes.
struct ValueDescription {
    std::string name;                  ///< "UNIT"; empty for a flag
    std::vector<std::string> choices;  ///< words that it may be; others may be valid too
    std::string limits;                ///< "2 to 6"; empty without limits
    bool takesFiles = false;
    bool takesFolders = false;
};

/// An option, or a positional argument.
struct OptionDescription {
    std::vector<std::string> names;  ///< "-h", "--help"; of a positional argument its one name, "files"
    std::string text;                ///< one sentence or more, without a full stop at the end
    ValueDescription value;
    std::string defaultValue;  ///< empty: none, or stated in `text`
    bool required = false;
    bool repeats = false;
    std::vector<std::string> needs;     ///< options that must be given too
    std::vector<std::string> excludes;  ///< options that may not be given too
};

/// A program or one of its commands.
struct CommandDescription {
    std::vector<std::string> words;  ///< "noonmark-cli", "project", "new"
    std::string text;
    std::string examples;  ///< lines of text, with indented commands
    std::vector<OptionDescription> options;
    std::vector<OptionDescription> positionals;
    std::vector<CommandDescription> commands;
};

/// Words that values may be and the parser does not know, by the name of the value: "ENGINE" -> "ray", ...
using KnownWords = std::map<std::string, std::vector<std::string>>;

/// Reads the parser's tree: hidden commands and options are left out, and the options of a group belong to
/// its command.
CommandDescription describeProgram(const CLI::App& program, const KnownWords& known = {});

/// All commands with words below the program, in the order of the tree: the program itself is the first.
std::vector<const CommandDescription*> listCommands(const CommandDescription& program);

/// The words of a command joined: "noonmark-cli project new" with a space between.
std::string joinWords(const std::vector<std::string>& words, std::string_view between);

/// The words after the program's name joined: "project/new" with a slash between, "" for the program.
std::string commandPath(const CommandDescription& command, std::string_view between);

}  // namespace noonmark::cli
