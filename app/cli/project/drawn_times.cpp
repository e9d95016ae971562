#include "app/cli/project/drawn_times.h"

#include <map>

#include "app/cli/options/project_options.h"
#include "app/cli/options/shared_options.h"
#include "core/receivers/place_names.h"

namespace noonmark::cli {

namespace {

Result<Box2> boxOfPlaces(const std::vector<std::string>& names, const Project& project) {
    Box2 box;
    for (const std::string& name : names) {
        const auto place = findPlace(project, name);
        if (!place) return tl::make_unexpected(place.error());
        box.add(bounds(*place));
    }
    return box;
}

}  // namespace

CLI::Option* addDrawnTimeOptions(CLI::App& command, DrawnTimeChoice& options) {
    CLI::Option* day = command.add_option("--day", options.days, "A day; may be repeated")
                           ->delimiter(',')
                           ->type_name("YYYY-MM-DD");
    CLI::Option* times =
        command.add_option("--times", options.times, "Times of day")->delimiter(',')->type_name("HH:MM,...");
    command.add_option("--every", options.everyMin, "Every so many minutes while the sun is up")
        ->check(within(1, 720))
        ->excludes(times)
        ->type_name("MIN");
    command.add_option("--zone", options.zone, "Time zone of the times")->required()->type_name("ZONE");
    return day;
}

Result<void> checkTimesGiven(const DrawnTimeChoice& options) {
    if (options.times.empty() && options.everyMin == 0)
        return failure("The times are missing", "times", "Give --times 09:00,12:00 or --every 60");
    return {};
}

void addPlaneOption(CLI::App& command, DrawingPlane& plane, const char* help) {
    static const std::map<std::string, DrawingPlane> names{{"local", DrawingPlane::local},
                                                           {"utm", DrawingPlane::utm}};
    const auto lower = [](const std::string& text) { return CLI::detail::to_lower(text); };
    command.add_option("--plane", plane, help)
        ->transform(CLI::CheckedTransformer(names, lower).description(""))
        ->type_name("local|utm");
}

void addDrawnAreaOptions(CLI::App& command, DrawnAreaOptions& options) {
    CLI::Option* region = command.add_option(
        "--region", options.region,
        "Draw the box around this region or place, a box in degrees, a polygon or a file (default: as far as "
        "the shadows of what changes reach)");
    region->type_name("REGION");
    command.add_option("--place", options.places, "Draw the box around this place; may be repeated")
        ->allow_extra_args(false)
        ->excludes(region)
        ->type_name("NAME");
}

Result<std::optional<Box2>> findDrawnArea(const DrawnAreaOptions& options, const Project& project,
                                          const City& city) {
    if (!options.region.empty())
        return regionIn(project, city, options.region).map([](const Region& region) {
            return std::optional(bounds(region));
        });
    if (options.places.empty()) return std::nullopt;
    return boxOfPlaces(options.places, project).map([](const Box2& box) { return std::optional(box); });
}

}  // namespace noonmark::cli
