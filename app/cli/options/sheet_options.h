#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <set>
#include <string>

#include "app/cli/base/command_line.h"
#include "app/cli/options/study_options.h"
#include "app/report/book/book.h"
#include "app/report/sheets/sheet.h"
#include "core/describe/command_options.h"
#include "core/io/files/check_output.h"
#include "core/measures/legend_choice.h"
#include "core/study/provenance/command_text.h"
#include "core/study/study.h"
#include "core/sun/period_fields.h"
#include "scenarios/project/project.h"
#include "scenarios/project/project_file.h"

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

/// Options shared by `impact`, `score` and `scenarios`: project, region, period, cells, engine and outputs.
struct MeasureOptions {
    std::string file;
    std::string region;
    std::string periodName;  // a period of the project; if empty, `period` counts
    PeriodOptions period{.names = periodFlagsBesideScenarios()};
    StudySettings settings;
    std::string out;
    bool overwrite = false;
    bool withProject = false;                   // copy the project beside the files
    int pictureWidth = noonmark::pictureWidth;  // of the PNG, pixels
    LegendChoice legend;                        // of maps and pages
    std::string keep;
    bool json = false;
};

void addMeasureOptions(CLI::App& command, MeasureOptions& options);

/// Adds --save and --with-project.
void addSaveOption(CLI::App& command, MeasureOptions& options);

/// The settings with region and period parsed. Error: the region is neither in the project nor a box nor a
/// file; errors of periodFrom().
Result<StudySettings> settingsFrom(const MeasureOptions& options, const Project& project);

/// Which files the outputs may replace.
OutputRules outputRulesOf(const MeasureOptions& options, const Project& project);

}  // namespace noonmark::cli
