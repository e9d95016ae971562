#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <set>
#include <string>

#include "core/describe/command_options.h"
#include "core/sun/period.h"

namespace noonmark::cli {

/// The days and hours of a command, as given by the user.
struct PeriodOptions {
    FlagNames names{};  ///< of flags that differ on this command
    Period period{};
    std::set<std::string, std::less<>> given{};  ///< flags of periodFields() that the user gave
    [[nodiscard]] bool states(std::string_view flag) const { return given.contains(flag); }
};

/// Returns the option of the first day, which the caller may require. `options` must outlive the parsing.
CLI::Option* addPeriodOptions(CLI::App& command, PeriodOptions& options);

/// The period, checked. Error: a zone that is unknown or, where clock hours need it, not given.
Result<Period> periodFrom(const PeriodOptions& options);

}  // namespace noonmark::cli
