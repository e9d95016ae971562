#include "app/cli/base/save_city.h"

#include <fmt/format.h>

#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/table.h"
#include "core/io/write_city.h"
#include "core/study/text/warnings_json.h"

namespace noonmark::cli {

namespace {

std::size_t partCount(const City& city) {
    std::size_t parts = 0;
    for (const auto& building : city.buildings) parts += building->parts.size();
    return parts;
}

void printJson(const City& city, const std::filesystem::path& file, const Warnings& warnings,
               std::ostream& out) {
    out << toJsonText({{"file", file.string()},
                       {"buildings", city.buildings.size()},
                       {"parts", partCount(city)},
                       {"warnings", warningsJson(warnings)}})
        << '\n';
}

}  // namespace

int saveCity(const City& city, const std::filesystem::path& file, bool json, const Console& console,
             const Warnings& ofReading) {
    const auto written = writeCityGeoPackage(file, city);
    if (!written) return fail(console, written.error(), exitFailed);
    Warnings warnings = ofReading;
    warnings.insert(warnings.end(), written->begin(), written->end());
    if (json) {
        printJson(city, file, warnings, console.out);
        return exitOk;
    }
    console.out << fmt::format("{}: {} buildings in {} parts\n", file.string(),
                               withCommas(city.buildings.size()), withCommas(partCount(city)));
    printWarnings(console.out, warnings);
    return exitOk;
}

}  // namespace noonmark::cli
