#include "app/cli/options/project_question.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/input/load_city.h"
#include "core/io/read_region.h"
#include "core/receivers/place_names.h"

namespace noonmark::cli {

namespace {

bool looksLikePlace(const std::string& text) {
    std::error_code ignored;
    return text.find_first_of(",(") != std::string::npos || std::filesystem::exists(text, ignored);
}

}  // namespace

Result<Region> regionIn(const Project& project, const City& city, const std::string& text) {
    auto region = findRegion(project, text);
    if (region) return region;
    if (text == "city") return cityRegion(city);
    if (auto place = findPlace(project.places, text)) return regionOf(*place);
    auto drawn = readRegion(text, project.city->frame);
    if (drawn || looksLikePlace(text)) return drawn;
    const auto close = findPlace(project.places, text);
    const std::string advice = project.places.empty() || !close.error().advice.starts_with("Did you mean")
                                   ? region.error().advice
                                   : close.error().advice;
    const std::string alternative = advice.ends_with('?') ? " Otherwise give" : "; or give";
    return failure("There is no such region or place", region.error().where,
                   advice + alternative + " a box, a polygon or a file");
}

void addNamedPeriod(CLI::App& command, const std::vector<CLI::Option*>& before, std::string& name) {
    CLI::Option* named = command.add_option("--period", name, "A period of the project, instead of --start");
    named->type_name("NAME");
    for (CLI::Option* option : command.get_options())
        if (option != named && std::ranges::find(before, option) == before.end()) named->excludes(option);
}

std::optional<std::string> commonZone(const Project& project) {
    std::set<std::string> zones;
    for (const NamedPeriod& period : project.periods) zones.insert(period.period.zone);
    return zones.size() == 1 ? std::optional(*zones.begin()) : std::nullopt;
}

Result<Period> periodIn(const Project& project, const std::string& name, const PeriodOptions& options) {
    if (!name.empty())
        return findPeriod(project, name).map([](const NamedPeriod& named) { return named.period; });
    if (options.states("--start")) return periodFrom(options);
    return failure("The period is missing", "period", "Give --start DATE, or --period NAME of the project");
}

}  // namespace noonmark::cli
