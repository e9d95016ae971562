#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/read_options.h"
#include "core/study/study.h"

namespace noonmark::cli {

/// The command line of `study`, as it was written.
struct StudyOptions {
    ReadOptions read;
    std::string start;
    std::string from;
    std::string window;
    std::string zone;
    std::string region;
    std::string out;
    StudySettings settings;  ///< what needs no city and no second look
    bool noRefraction = false;
    bool centre = false;  ///< sunrise rule of the window
    bool json = false;
    bool cellsCsv = false;
};

void addStudyOptions(CLI::App& command, StudyOptions& options);

/// The period that the options mean. Error: a text that is no date, time, window or zone; hours without a
/// zone.
Result<Period> periodFrom(const StudyOptions& options);

}  // namespace noonmark::cli
