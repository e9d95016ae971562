#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/study/study.h"

namespace noonmark {

/// An option of a command with its values; none: a flag.
struct RepeatOption {
    std::string name;
    std::vector<std::string> values;
};

/// --error-sample, where it is not the usual one.
void addErrorSample(const ErrorSampleSettings& sample, std::vector<RepeatOption>& options);

/// A question as a command line puts it.
struct RepeatQuestion {
    std::string command;  ///< "study"
    StudySettings settings;
    Provenance provenance;                ///< its region is set
    std::string engineKey;                ///< that was picked; empty: the one of the settings
    std::string hourOption = "--from";    ///< of the first step's wall clock
    bool needsProject = false;            ///< the command takes no city files
    std::vector<RepeatOption> options{};  ///< of this command alone
};

/// The noonmark-cli command line that gives the same figures again, for a POSIX shell, in a folder that holds
/// copies of the inputs, or of the project file, and region.geojson where the region is one that only that
/// file states. Settings that have their default value and do not belong to the question are left out. Lines
/// longer than `width` letters go on, after a backslash, on the next. Error, with what to do: the project
/// was not saved as it was measured, or nobody said what the city was read from.
Result<std::string> repeatCommand(const RepeatQuestion& question, std::size_t width = 120);

/// The same of a study. `command`: "study", or another that takes its options and `more`.
Result<std::string> repeatCommand(const Study& study, std::size_t width = 120,
                                  const std::string& command = "study", std::vector<RepeatOption> more = {});

/// Whether the command names region.geojson, which then lies beside the outputs.
bool needsRegionFile(const Study& study);

}  // namespace noonmark
