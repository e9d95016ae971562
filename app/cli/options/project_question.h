#pragma once

#include <optional>
#include <string>

#include "app/cli/options/period_options.h"
#include "scenarios/project/project.h"

namespace noonmark::cli {

/// Parses `--region` of a command on a project: a region or place of the project by name, "city" for the box
/// around all buildings of `city`, or the forms of readRegion().
Result<Region> regionIn(const Project& project, const City& city, const std::string& text);

/// Adds `--period NAME`, a period of the project. It excludes the options for days and hours, that is, those
/// added to `command` since `before`.
void addNamedPeriod(CLI::App& command, const std::vector<CLI::Option*>& before, std::string& name);

/// The zone that all periods of the project have; none without periods, or if they have several.
std::optional<std::string> commonZone(const Project& project);

/// The named period of the project, or else the period of the options. Error: neither is given.
Result<Period> periodIn(const Project& project, const std::string& name, const PeriodOptions& options);

}  // namespace noonmark::cli
