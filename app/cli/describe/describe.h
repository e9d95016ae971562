#pragma once

// The folder app/cli/describe/ turns the description of a command line, as the parser has it, into manual
// pages and into completions for bash, zsh and fish. command_description.h reads the parser's tree once; each
// of the other files writes one format from it. They are written when the programs are built, so that no
// command or option is described twice (cmake/NoonmarkInstall.cmake).

#include <string>
#include <vector>

#include "app/cli/describe/command_description.h"

namespace noonmark::cli {

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
