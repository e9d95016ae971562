#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "core/base/units.h"

namespace noonmark::cli {

/// Adds an option that takes LON,LAT in degrees.
CLI::Option* addLonLatOption(CLI::App& command, const std::string& name, std::optional<LonLat>& place,
                             const std::string& about);

}  // namespace noonmark::cli
