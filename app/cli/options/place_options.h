#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/describe/command_options.h"
#include "core/io/places/read_places.h"

namespace noonmark::cli {

/// Which places a command reads or lists.
struct PlaceOptions {
    PlaceSettings settings;
    std::vector<std::string> kinds;  ///< as typed; checked by the parser
    bool named = false;

    /// Whether a place of a project is of the kinds and size wanted.
    [[nodiscard]] bool admits(const Place& place) const;
};

/// Those that differ from what by-place takes where nothing is stated.
std::vector<CommandOption> listOptions(const PlaceOptions& options);

/// Width of sidewalks that by-place takes where none is stated, m.
inline constexpr double defaultSidewalkM = 4;

/// Adds --kind, --streets, --whole-streets, --sidewalks, --named, --least-area, --name-field, --as,
/// --place-layer and --place-crs. `options` must outlive the parsing.
void addPlaceOptions(CLI::App& command, PlaceOptions& options);

}  // namespace noonmark::cli
