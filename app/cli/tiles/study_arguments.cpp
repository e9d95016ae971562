#include "app/cli/tiles/study_arguments.h"

#include "app/cli/options/field_options.h"
#include "core/describe/command_flags.h"

#include <fmt/format.h>

#include <algorithm>

namespace noonmark::cli {

std::vector<std::string> listArguments(const CLI::App& command, const std::vector<std::string>& leaveOut) {
    std::vector<std::string> words;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || !name.starts_with("--")) continue;
        if (std::ranges::find(leaveOut, name) != leaveOut.end()) continue;
        if (option->get_items_expected_max() == 0) {
            words.push_back(name);
            continue;
        }
        for (const std::string& value : option->results()) words.push_back(fmt::format("{}={}", name, value));
    }
    return words;
}

namespace {

// Sidewalks as by-place has them, where none are stated.
void addByPlaceOptions(CLI::App& command, TileStudyOptions& options) {
    CLI::Option* byPlace =
        command
            .add_option("--by-place", options.byPlace,
                        "Measure the sun of the places of this file (polygons, or OpenStreetMap) or, of a "
                        "project, of its own places: the project")
            ->excludes(command.get_option(flags::weights))
            ->excludes(command.get_option("--timelines"))
            ->excludes(command.get_option("--by"))
            ->type_name("FILE");
    const std::vector<CLI::Option*> before = command.get_options();
    addFieldOptions(command, sunByPlaceFields().of(options.sun));
    for (CLI::Option* option : command.get_options())
        if (std::ranges::find(before, option) == before.end()) option->needs(byPlace);
    const CLI::Option* sidewalks = command.get_option("--sidewalks");
    command.parse_complete_callback([&options, byPlace, sidewalks] {
        if (byPlace->count() > 0 && sidewalks->count() == 0)
            options.places.settings.sidewalkM = PlaceSettings::defaultSidewalkM;
    });
}

}  // namespace

void addTileStudyOptions(CLI::App& command, TileStudyOptions& options) {
    addStudyOptions(command, options.study);
    addMonthOption(command, options.study.settings);
    CLI::Option* baseline =
        command
            .add_option("--baseline", options.baseline,
                        "Measure the impact of the project's --scenario: the scenario to compare it with")
            ->needs(command.get_option(flags::scenario))
            ->type_name("NAME");
    CLI::Option* weights = command
                               .add_option(flags::weights, options.weights,
                                           "Measure the shadow score: a time-weight table of the project")
                               ->excludes(baseline)
                               ->type_name("NAME");
    CLI::Option* timelines =
        command
            .add_option("--timelines", options.timelines,
                        "Measure the timelines of the places of this file (polygons, or OpenStreetMap)")
            ->excludes(weights)
            ->excludes(command.get_option("--by"))
            ->type_name("FILE");
    command.add_flag("--all-steps", options.allSteps, "Of timelines of several days, state the steps too")
        ->needs(timelines);
    addPlaceOptions(command, options.places);
    addByPlaceOptions(command, options);
}

Result<TileStudyOptions> parseArguments(const std::vector<std::string>& arguments,
                                        const std::vector<std::string>& files) {
    CLI::App parser;
    TileStudyOptions options;
    addTileStudyOptions(parser, options);
    std::vector<std::string> words{"city", "--out=folder"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::ranges::reverse(words);  // the parser takes them from the back
    try {
        parser.parse(words);
    } catch (const CLI::ParseError& error) {
        return failure(std::string("The options of the plan cannot be used: ") + error.what(), "plan.json",
                       "Plan again with this version");
    }
    options.study.read.files = files;
    return options;
}

}  // namespace noonmark::cli
