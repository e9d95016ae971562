#pragma once

#include <filesystem>

#include "app/cli/base/command_line.h"
#include "core/base/warnings.h"
#include "core/city/city.h"

namespace noonmark::cli {

/// Writes a city as a GeoPackage and reports it, for `sample` and `import`. Returns an ExitCode.
int saveCity(const City& city, const std::filesystem::path& file, bool json, const Console& console,
             const Warnings& ofReading = {});

/// What was written, as its figures or as JSON.
struct SavedBuildings {
    std::filesystem::path file;
    std::size_t buildings = 0, parts = 0;
    std::string note{};  ///< a line for people; empty: none
    Warnings warnings{};
};
void printSaved(const SavedBuildings& saved, bool json, std::ostream& out);

}  // namespace noonmark::cli
