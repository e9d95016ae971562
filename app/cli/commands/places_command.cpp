#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/project_options.h"
#include "app/cli/study/study_request.h"
#include "app/input/load_city.h"
#include "core/base/safe_text.h"
#include "core/receivers/place_names.h"
#include "core/study/text/error_text.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

using Json = nlohmann::ordered_json;

struct PlacesOptions {
    ReadOptions read;
    PlaceOptions place;
    std::vector<std::string> from;
    bool json = false;
};

struct ListedPlaces {
    Frame frame;
    PlacesRead read;
};

Result<ListedPlaces> placesOfProject(const PlacesOptions& options, Progress& progress,
                                     const std::stop_token& stop) {
    if (auto alone = checkProjectAlone(options.read); !alone) return tl::make_unexpected(alone.error());
    const auto disk = ProjectFile::open(options.read.files.front());
    if (!disk) return tl::make_unexpected(disk.error());
    const Frame frame = disk->project().city->frame;
    PlacesRead there{.places = disk->project().places};
    return loadPlaceFiles(options.from, options.place.settings, frame, std::move(there), progress, stop)
        .map([&](PlacesRead read) {
            return ListedPlaces{frame, std::move(read)};
        });
}

Result<ListedPlaces> placesOfFiles(const PlacesOptions& options, Progress& progress,
                                   const std::stop_token& stop) {
    const auto city = noonmark::loadCity(options.read.files, options.read.settings, progress, stop);
    if (!city) return tl::make_unexpected(city.error());
    const Frame frame = city->read.city.frame;
    auto own = loadCityPlaces(options.read.files, options.place.settings, frame, progress, stop);
    if (!own) return tl::make_unexpected(own.error());
    return loadPlaceFiles(options.from, options.place.settings, frame, *std::move(own), progress, stop)
        .map([&](PlacesRead read) {
            return ListedPlaces{frame, std::move(read)};
        });
}

Json placeJson(const Place& place, const Frame& frame) {
    const Box2 box = bounds(place);
    const LonLat middle = frame.lonLatFromLocal((glm::dvec2(box.low) + glm::dvec2(box.high)) * 0.5);
    return {{"name", place.name},     {"kind", nameOf(place.kind)},
            {"area_m2", area(place)}, {"polygons", place.polygons.size()},
            {"source", place.source}, {"lon", middle.lonDeg},
            {"lat", middle.latDeg}};
}

void printJson(const ListedPlaces& listed, std::ostream& out) {
    Json places = Json::array();
    for (const Place& place : listed.read.places) places.push_back(placeJson(place, listed.frame));
    out << toJsonText({{"places", places},
                       {"attribution", listed.read.attribution},
                       {"streets_of_assumed_width", listed.read.streetsOfAssumedWidth},
                       {"warnings", warningsJson(listed.read.warnings)}})
        << '\n';
}

void print(const ListedPlaces& listed, std::ostream& out) {
    for (const Place& place : listed.read.places)
        out << fmt::format("{:<44} {:<13} {:>10} m2  {}\n", place.name, nameOf(place.kind),
                           withCommas(std::size_t(std::llround(area(place)))), place.source);
    out << countOf(listed.read.places.size(), "place") << '\n';
    printWarnings(out, listed.read.warnings);
}

int runPlaces(const PlacesOptions& options, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    auto listed = namesProject(options.read) ? placesOfProject(options, progress, interrupt.token())
                                             : placesOfFiles(options, progress, interrupt.token());
    if (!listed) return fail(console, listed.error(), exitUsage);
    std::erase_if(listed->read.places, [&](const Place& place) { return !options.place.admits(place); });
    options.json ? printJson(*listed, console.out) : print(*listed, console.out);
    return exitOk;
}

}  // namespace

void addPlacesCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<PlacesOptions>();
    CLI::App* command = app.add_subcommand(
        "places", "List the places of a city or a project: parks, playgrounds, squares, streets and others");
    options->read.filesHelp = "City files, a sample, or one project";
    addReadOptions(*command, options->read);
    command->add_option("--from", options->from, "Also list the places of this file; may be repeated")
        ->allow_extra_args(false)
        ->type_name("FILE");
    addPlaceOptions(*command, options->place);
    addJsonFlag(*command, options->json);
    command->callback([options, &run] {
        run = [options](const Console& console) { return runPlaces(*options, console); };
    });
}

}  // namespace noonmark::cli
