#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "app/cli/base/command_line.h"
#include "app/cli/options/study_options.h"
#include "app/report/sheets/sheet.h"
#include "core/io/files/check_output.h"
#include "core/measures/legend_choice.h"
#include "core/study/study.h"
#include "core/sun/period_fields.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

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
