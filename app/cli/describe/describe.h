#pragma once

// The folder app/cli/describe/ turns the description of a command line, as the parser has it, into manual
// pages and into completions for bash, zsh and fish. describe.h reads the parser's tree once; each
// of the other files writes one format from it. They are written when the programs are built, so that no
// command or option is described twice (cmake/NoonmarkInstall.cmake).

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

/// A file to write: "noonmark-cli.1".
struct DescriptionFile {
    std::string name;
    std::string text;
};

/// A section of a manual page that does not follow from the command line, as lines of plain text. A line that
/// starts with a tabulator explains the line before it.
struct ManualSection {
    std::string title;  ///< "EXIT STATUS"
    std::vector<std::string> lines;
};

/// What all manual pages of a program state besides its command line.
struct ManualFacts {
    std::string version;  ///< "0.1.0"
    std::string date;     ///< of the release: "2026-11-24"
    std::vector<ManualSection> sections;
    std::vector<std::string> seeAlso;  ///< names of other pages in section 1
};

/// Manual pages in the man macros, without warnings of `mandoc -Tlint`: NAME.1 about the program, and
/// NAME-COMMAND.1 about each of its commands, with the commands of that command.
std::vector<DescriptionFile> writeManualPages(const CommandDescription& program, const ManualFacts& facts);

/// Completions by the names that each shell looks for: NAME, _NAME and NAME.fish. They complete commands,
/// options, the words that an option may take, and names of files.
DescriptionFile writeBashCompletion(const CommandDescription& program);
DescriptionFile writeZshCompletion(const CommandDescription& program);
DescriptionFile writeFishCompletion(const CommandDescription& program);

/// The help of each command as a C++ source, help_texts.cpp, from which noonmark-cli answers --help without
/// loading the libraries of the program (app/launcher).
DescriptionFile writeHelpSource(const CLI::App& program);

}  // namespace noonmark::cli
