#include "app/gui/session/project/open_project.h"

#include "app/input/load_city.h"
#include "app/input/load_project.h"

namespace noonmark {

namespace {

void goToScenario(OpenProject& opened, LoadedCity& loaded) {
    const auto edited = cityOf(opened.project, opened.view.scenario);
    if (edited) return void(loaded.read.city = edited->city);
    loaded.read.warnings.push_back({WarningKind::leftOut, edited.error().what, edited.error().where});
    opened.view.scenario = existingCity;
}

Result<LoadedCity> readProjectFile(const std::string& file, OpenProject& opened, Progress& progress,
                                   const std::stop_token& stop) {
    progress.report(0.1, "reading the project");
    auto disk = ProjectFile::open(file);
    if (!disk) return tl::make_unexpected(disk.error());
    opened.project = withLoadedPhotograph(disk->project(), opened.placeWarnings, progress, stop);
    opened.view = parseViewState(opened.project.view);
    opened.file = *std::move(disk);
    LoadedCity loaded = loadProjectCity(opened.project, file);
    goToScenario(opened, loaded);
    return loaded;
}

// The map's places come with it, as on the command line. A map whose places cannot be read is still a city.
Result<void> readMapPlaces(const std::vector<std::string>& files, OpenProject& opened, Progress& progress,
                           const std::stop_token& stop) {
    auto read = loadCityPlaces(files, {}, opened.project.city->frame, progress, stop);
    if (!read && isCancelled(read.error())) return tl::make_unexpected(read.error());
    if (!read) {
        opened.placeWarnings.push_back({WarningKind::leftOut, read.error().what, read.error().where});
        return {};
    }
    opened.project.places = std::move(read->places);
    opened.placeWarnings = std::move(read->warnings);
    return {};
}

/// Streets, parks and water of the map; a map without them is still a city.
Result<void> readMapContext(const std::vector<std::string>& files, OpenProject& opened, Progress& progress,
                            const std::stop_token& stop) {
    auto read = loadCityContext(files, opened.project.city->frame, progress, stop);
    if (!read && isCancelled(read.error())) return tl::make_unexpected(read.error());
    if (!read) {
        opened.placeWarnings.push_back({WarningKind::leftOut, read.error().what, read.error().where});
        return {};
    }
    City city = *opened.project.city;
    city.context = joinContext(nullptr, std::move(read->context));
    opened.project.city = std::make_shared<const City>(std::move(city));
    return {};
}

Result<LoadedCity> readCityFiles(const std::vector<std::string>& files, const ReadSettings& settings,
                                 OpenProject& opened, Progress& progress, const std::stop_token& stop) {
    return loadCity(files, settings, progress, stop).and_then([&](LoadedCity loaded) -> Result<LoadedCity> {
        opened.project = projectOf(loaded);
        if (auto read = readMapPlaces(files, opened, progress, stop); !read)
            return tl::make_unexpected(read.error());
        if (auto read = readMapContext(files, opened, progress, stop); !read)
            return tl::make_unexpected(read.error());
        loaded.read.city = *opened.project.city;
        return loaded;
    });
}

}  // namespace

bool isProject(const std::vector<std::string>& files) {
    return files.size() == 1 && isProjectFile(files.front());
}

Result<OpenProject> openProject(const std::vector<std::string>& files, const ReadSettings& settings,
                                Progress& progress, const std::stop_token& stop) {
    OpenProject opened;
    auto loaded = isProject(files) ? readProjectFile(files.front(), opened, progress, stop)
                                   : readCityFiles(files, settings, opened, progress, stop);
    if (!loaded) return tl::make_unexpected(loaded.error());
    // Of a scenario, the arrays are those of the existing city: what is demolished shows as outlines.
    std::shared_ptr<const CityArrays> existing;
    if (opened.view.scenario != existingCity && opened.project.city)
        existing = std::make_shared<const CityArrays>(makeArrays(*opened.project.city));
    opened.zone = findNearestZone(loaded->read.city.frame.origin());
    return shownCity(*std::move(loaded), std::move(existing), progress, stop).map([&](OpenCity city) {
        opened.city = std::move(city);
        return std::move(opened);
    });
}

LoadedCity withCity(LoadedCity loaded, const City& city) {
    loaded.read.city = city;
    return loaded;
}

}  // namespace noonmark
