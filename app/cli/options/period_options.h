#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/sun/period.h"

namespace noonmark::cli {

/// The days and hours of a command, as given by the user.
struct PeriodOptions {
    std::string hourOption = "--from";    ///< option for the time of day of the first step
    std::string startOption = "--start";  ///< option for the first day
    std::string start;
    std::string from;
    std::string window;
    std::string zone;
    bool noRefraction = false;
    bool centre = false;  ///< sunrise rule of the window
    Period period;        ///< the values that need no further parsing
};

/// Returns the option of the first day, which the caller may require. `options` must outlive the parsing.
CLI::Option* addPeriodOptions(CLI::App& command, PeriodOptions& options);

/// Parses the period. Error: an invalid date, time, window or zone; hours without a zone.
Result<Period> periodFrom(const PeriodOptions& options);

}  // namespace noonmark::cli
