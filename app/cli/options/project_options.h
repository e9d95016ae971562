#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/study_options.h"
#include "core/describe/command_options.h"
#include "core/io/places/read_places.h"
#include "scenarios/project/project.h"

namespace noonmark::cli {

/// Which places a command reads or lists.
struct PlaceOptions {
    PlaceSettings settings;
    std::vector<std::string> kinds;  ///< as typed; checked by the parser
    bool named = false;

    /// Whether a place of a project is of the kinds and size wanted.
    [[nodiscard]] bool admits(const Place& place) const;
};

/// The options that differ from the defaults of by-place.
std::vector<CommandOption> listOptions(const PlaceOptions& options);

/// Width of sidewalks that by-place takes where none is stated, m.
inline constexpr double defaultSidewalkM = 4;

/// Adds --kind, --streets, --whole-streets, --sidewalks, --named, --least-area, --name-field, --as,
/// --place-layer and --place-crs. `options` must outlive the parsing.
void addPlaceOptions(CLI::App& command, PlaceOptions& options);

/// Parses `--region` of a command on a project: a region or place of the project by name, "city" for the box
/// around all buildings of `city`, or the forms of readRegion().
Result<Region> regionIn(const Project& project, const City& city, const std::string& text);

/// Adds `--period NAME`, a period of the project. It excludes the options for days and hours, that is, those
/// added to `command` since `before`.
void addNamedPeriod(CLI::App& command, const std::vector<CLI::Option*>& before, std::string& name);

/// The zone that all periods of the project have, or without periods that of the study which the window
/// saved; none if they have several.
std::optional<std::string> commonZone(const Project& project);

/// The named period of the project, or else the period of the options. Error: neither is given.
Result<Period> periodIn(const Project& project, const std::string& name, const PeriodOptions& options);

}  // namespace noonmark::cli
