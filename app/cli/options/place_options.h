#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

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

/// Adds --kind, --streets, --whole-streets, --sidewalks, --named, --least-area, --name-field, --as,
/// --place-layer and --place-crs. `options` must outlive the parsing.
void addPlaceOptions(CLI::App& command, PlaceOptions& options);

}  // namespace noonmark::cli
