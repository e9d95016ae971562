#include "app/cli/base/save_city.h"

#include <fmt/format.h>

#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/terminal_text.h"
#include "core/base/safe_text.h"
#include "core/io/write_city.h"
#include "core/study/text/error_text.h"

namespace noonmark::cli {

namespace {

std::size_t partCount(const City& city) {
    std::size_t parts = 0;
    for (const auto& building : city.buildings) parts += building->parts.size();
    return parts;
}

}  // namespace

void printSaved(const SavedBuildings& saved, bool json, std::ostream& out) {
    if (json) {
        out << toJsonText({{"file", saved.file.string()},
                           {"buildings", saved.buildings},
                           {"parts", saved.parts},
                           {"warnings", warningsJson(saved.warnings)}})
            << '\n';
        return;
    }
    out << fmt::format("{}: {} in {}\n", saved.file.string(), countOf(saved.buildings, "building"),
                       countOf(saved.parts, "part"));
    if (!saved.note.empty()) out << "  " << saved.note << '\n';
    printWarnings(out, saved.warnings);
}

int saveCity(const City& city, const std::filesystem::path& file, bool json, const Console& console,
             const Warnings& ofReading) {
    const auto written = writeCityGeoPackage(file, city);
    if (!written) return fail(console, written.error(), exitFailed);
    Warnings warnings = ofReading;
    warnings.insert(warnings.end(), written->begin(), written->end());
    printSaved({file, city.buildings.size(), partCount(city), {}, std::move(warnings)}, json, console.out);
    return exitOk;
}

}  // namespace noonmark::cli
