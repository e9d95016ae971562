#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/sun/period.h"

namespace noonmark::cli {

/// The days and hours of a command, as they were written.
struct PeriodOptions {
    std::string hourOption = "--from";  ///< the option of the first step's wall clock
    std::string start;
    std::string from;
    std::string window;
    std::string zone;
    bool noRefraction = false;
    bool centre = false;  ///< sunrise rule of the window
    Period period;        ///< what needs no second look
};

/// Returns the option of the first day, for the caller to require. `options` outlives the parsing.
CLI::Option* addPeriodOptions(CLI::App& command, PeriodOptions& options);

/// The period that the options mean. Error: a text that is no date, time, window or zone; hours without a
/// zone.
Result<Period> periodFrom(const PeriodOptions& options);

}  // namespace noonmark::cli
