#include "scenarios/project/project.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

constexpr double farthestM = 1e7;

bool isWithin(double value, double low, double high) { return value >= low && value <= high; }

}  // namespace

bool isBox(const ViewBox& box) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.lowM[axis] >= -farthestM && box.highM[axis] <= farthestM &&
              box.lowM[axis] < box.highM[axis]))
            return false;
    return true;
}

Result<void> validate(const SavedView& view) {
    const glm::dvec3 target = view.targetM;
    const bool near = std::max({std::abs(target.x), std::abs(target.y), std::abs(target.z)}) <= farthestM;
    const bool camera = near && isWithin(view.distanceM, 1e-3, farthestM) &&
                        isWithin(view.headingDeg, 0, 360) && isWithin(view.pitchDeg, 0, 90);
    const bool moment =
        !view.moment || (view.moment->date.ok() && isWithin(double(view.moment->at.count()), 0, 24 * 60));
    if (camera && moment && (!view.section || isBox(*view.section))) return {};
    return failure("The camera, the moment or the section box of a saved view is out of range",
                   "view '" + view.name + "'", "Delete the view and save it again");
}

std::string formatText(const GroundPictureFile& picture) {
    return nlohmann::ordered_json{{"path", picture.path.string()},
                                  {"sha256", picture.sha256},
                                  {"attribution", picture.attribution},
                                  {"opacity", picture.opacity},
                                  {"shown", picture.shown}}
        .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::optional<GroundPictureFile> parseGroundPicture(const std::string& text) try {
    const auto json = nlohmann::json::parse(text);
    GroundPictureFile picture{json.at("path").get<std::string>(), json.at("sha256"), json.at("attribution"),
                              json.at("opacity"), json.at("shown")};
    const bool sound = !picture.path.empty() && picture.opacity >= 0 && picture.opacity <= 1;
    return sound ? std::optional(picture) : std::nullopt;
} catch (const nlohmann::json::exception&) {
    return std::nullopt;
}

Project withGroundPicture(Project project, std::optional<GroundPictureFile> file,
                          std::shared_ptr<const GroundRaster> raster) {
    auto context =
        std::make_shared<MapContext>(project.city->context ? *project.city->context : MapContext{});
    const bool drawn = file && file->shown && raster;
    context->picture =
        drawn ? std::optional(ContextPicture{std::move(raster), file->opacity, file->attribution})
              : std::nullopt;
    City city = *project.city;
    city.context = context->empty() ? nullptr : std::move(context);
    project.city = std::make_shared<const City>(std::move(city));
    project.groundPicture = std::move(file);
    return project;
}

namespace {

constexpr auto ownName = [](const auto& one) -> const std::string& { return one.name; };
constexpr auto sharedName = [](const auto& one) -> const std::string& { return one->name; };

template <class T, class Name>
Result<T> findNamed(const std::vector<T>& list, Name nameOf, const std::string& name, const char* what) {
    const auto found = std::ranges::find(list, name, nameOf);
    if (found != list.end()) return *found;
    std::vector<std::string> names;
    for (const T& one : list) names.push_back("'" + nameOf(one) + "'");
    return failure(fmt::format("There is no such {}", what), fmt::format("{} '{}'", what, name),
                   names.empty() ? fmt::format("The project has none")
                                 : fmt::format("There are: {}", fmt::join(names, ", ")));
}

template <class Range, class Name>
Result<void> checkNames(const Range& list, Name nameOf, const char* what) {
    std::set<std::string> names;
    for (const auto& one : list) {
        if (nameOf(one).empty()) return failure(fmt::format("A {} has no name", what), "project", "Name it");
        if (!names.insert(nameOf(one)).second)
            return failure(fmt::format("Another {} of the project has this name", what), nameOf(one),
                           "Choose another name");
    }
    return {};
}

}  // namespace

Result<NamedLot> findLot(const Project& project, const std::string& name) {
    return findNamed(project.lots, ownName, name, "lot");
}
Result<Region> findRegion(const Project& project, const std::string& name) {
    return findNamed(project.regions, ownName, name, "region");
}
Result<Place> findPlace(const Project& project, const std::string& name) {
    if (project.places.empty())
        return failure("The project has no places", "place '" + name + "'",
                       "Read them from a map: noonmark-cli project place read PROJECT FILE");
    return findPlace(project.places, name);
}

std::vector<Place> placesOfKind(const Project& project, PlaceKind kind) {
    std::vector<Place> places;
    std::ranges::copy_if(project.places, std::back_inserter(places),
                         [&](const Place& place) { return place.kind == kind; });
    return places;
}
Result<TimeWeights> findWeights(const Project& project, const std::string& name) {
    return findNamed(project.weights, ownName, name, "weight table");
}
Result<NamedPeriod> findPeriod(const Project& project, const std::string& name) {
    return findNamed(project.periods, ownName, name, "period");
}
Result<std::shared_ptr<const SavedResult>> findResult(const Project& project, const std::string& name) {
    return findNamed(project.results, sharedName, name, "saved result");
}
Result<Scenario> findScenarioByName(const Project& project, const std::string& name) {
    return findNamed(project.scenarios, ownName, name, "scenario");
}

Result<EditedCity> cityOf(const Project& project, const std::string& scenario) {
    return cityOf(*project.city, project.scenarios, scenario);
}

namespace {

Result<void> checkSize(const std::vector<std::shared_ptr<const SavedResult>>& results) {
    std::size_t cells = 0;
    for (const auto& result : results) cells += result->layers.size() * result->grid.size();
    if (cells <= maxLayerCells) return {};
    return limitReached(
        fmt::format("The saved results have {:.0f} million cells", double(cells) / 1e6), "saved results",
        fmt::format("Remove some: a project holds {:.0f} million", double(maxLayerCells) / 1e6));
}

}  // namespace

Result<void> validate(const Project& project) {
    Result<void> sound = validate(project.scenarios);
    if (sound) sound = checkNames(project.lots, ownName, "lot");
    if (sound) sound = checkNames(project.regions, ownName, "region");
    if (sound) sound = checkNames(project.places, ownName, "place");
    if (sound) sound = checkNames(project.weights, ownName, "weight table");
    if (sound) sound = checkNames(project.periods, ownName, "period");
    if (sound) sound = checkNames(project.views, ownName, "view");
    if (sound) sound = checkNames(project.results, sharedName, "result");
    if (sound) sound = checkSize(project.results);
    for (const TimeWeights& table : project.weights)
        if (sound) sound = validate(table);
    for (const SavedView& view : project.views)
        if (sound) sound = validate(view);
    if (sound) sound = validate(project.sheets.titleBlock);
    return sound;
}

}  // namespace noonmark
