#pragma once

#include <string>

#include "app/cli/options/period_options.h"
#include "scenarios/project/project.h"

namespace noonmark::cli {

/// `--region` of a question about a project: a region of the project by its name, "city" for the box around
/// all buildings of `city`, or what readRegion takes.
Result<Region> regionIn(const Project& project, const City& city, const std::string& text);

/// `--period NAME` of the project, which excludes all options of days and hours that `command` has got since
/// `before`.
void addNamedPeriod(CLI::App& command, const std::vector<CLI::Option*>& before, std::string& name);

/// A period of the project by its name where that is given, else by the options. Error: neither.
Result<Period> periodIn(const Project& project, const std::string& name, const PeriodOptions& options);

}  // namespace noonmark::cli
