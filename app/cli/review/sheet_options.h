#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/report/book/review/review_book.h"
#include "scenarios/project/project.h"

namespace noonmark::cli {

/// How sheets.pdf is laid out, and what its title block states.
struct SheetOptions {
    std::string paper = "A4";
    bool landscape = false;
    double scale = 0;  ///< 0: chosen to fit
    std::string project, author, client, date, prefix, logo;
};

/// Adds --paper, --landscape, --scale, and the texts of the title block. `options` must outlive the command.
void addSheetOptions(CLI::App& command, SheetOptions& options);

/// `ofProject`: units, and a title block of which the options replace texts. Error: the logo cannot be read,
/// and those of validate() for title blocks.
Result<BookSettings> bookSettingsOf(const SheetOptions& options, const SheetSettings& ofProject);

}  // namespace noonmark::cli
