#pragma once

#include <CLI/CLI.hpp>
#include <set>
#include <string>

#include "app/report/book/book.h"
#include "core/describe/command_options.h"
#include "core/study/provenance/command_words.h"
#include "scenarios/project/project.h"

namespace noonmark::cli {

/// How sheets.pdf is laid out, and what its title block states.
struct SheetOptions {
    BookSettings layout{};                       ///< with the texts of the title block that the user gave
    bool wanted = false;                         ///< --sheets
    std::set<std::string, std::less<>> given{};  ///< flags of titleFields() that the user gave
    std::string logo;
};

/// Adds --paper, --landscape, and the texts of the title block. `options` must outlive the command. `names`:
/// of flags that the command has for something else.
void addSheetOptions(CLI::App& command, SheetOptions& options, const FlagNames& names = {});
/// Adds --scale.
void addDiagramScale(CLI::App& command, SheetOptions& options);
/// Adds the options of extentFields().
void addBookExtent(CLI::App& command, SheetOptions& options);
/// Adds --sheets, for commands that write sheets.pdf on request only.
void addSheetSwitch(CLI::App& command, SheetOptions& options);

/// `ofProject`: units, and a title block of which the options replace texts. The date is today's if neither
/// states one. Error: the logo cannot be read,
/// and those of validate() for title blocks.
Result<BookSettings> bookSettingsOf(const SheetOptions& options, const SheetSettings& ofProject);

/// The texts of the title block that the user gave, all but the date, which the book restates.
std::vector<CommandOption> makeRepeatOptions(const SheetOptions& options);

/// Adds the options of elements.pdf: those of addSheetOptions(), and --scale of its elevations. `options`
/// must outlive the command.
void addElevationSheetOptions(CLI::App& command, SheetOptions& options);

}  // namespace noonmark::cli
