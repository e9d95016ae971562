#pragma once

#include <filesystem>

#include "app/cli/base/console.h"
#include "core/base/warnings.h"
#include "core/city/city.h"

namespace noonmark::cli {

/// Writes a city as a GeoPackage and reports it, for `sample` and `import`. Returns an ExitCode.
int saveCity(const City& city, const std::filesystem::path& file, bool json, const Console& console,
             const Warnings& ofReading = {});

}  // namespace noonmark::cli
