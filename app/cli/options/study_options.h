#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/options/period_options.h"
#include "app/cli/options/read_options.h"
#include "core/study/study.h"

namespace noonmark::cli {

/// The command line of `study`, as it was written.
struct StudyOptions {
    ReadOptions read;
    PeriodOptions period;
    std::string scenario;    ///< of a project; empty: not given
    std::string periodName;  ///< of a project; else `period`
    std::string region;
    std::string out;
    bool overwrite = false;
    StudySettings settings;  ///< what needs no city and no second look
    bool json = false;
    bool cellsCsv = false;
};

/// What every study takes.
void addStudyOptions(CLI::App& command, StudyOptions& options);

/// What a study in one piece takes besides: months, contributions, the cells as a table.
void addPieceOptions(CLI::App& command, StudyOptions& options);

/// --error-sample and --no-error-sample.
void addErrorOptions(CLI::App& command, ErrorSampleSettings& sample);

/// --cell, --pressure and --temperature.
void addReceiverOptions(CLI::App& command, StudySettings& settings);

}  // namespace noonmark::cli
