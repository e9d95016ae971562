#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "app/cli/console.h"
#include "app/cli/options/period_options.h"
#include "core/io/files/check_output.h"
#include "core/study/study.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

/// What `impact` and `score` share: project, region, period, cells, engine, and where the answer goes.
struct MeasureOptions {
    std::string file;
    std::string region;
    std::string periodName;  // of the project; else `period`
    PeriodOptions period{.hourOption = "--at"};
    StudySettings settings;
    std::string out;
    bool overwrite = false;
    std::string keep;
    bool json = false;
};

void addMeasureOptions(CLI::App& command, MeasureOptions& options);

/// The settings with region and period read. Error: a region that the project does not have and that is
/// neither a box nor a file; what periodFrom refuses.
Result<StudySettings> settingsFrom(const MeasureOptions& options, const Project& project);

/// What the answer may be written over.
OutputRules outputRulesOf(const MeasureOptions& options, const Project& project);

}  // namespace noonmark::cli
