#include "app/input/load_project.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/io/files/geopackage_check.h"
#include "core/samples/sample_city.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/project/project_file.h"

namespace noonmark {

bool isProjectFile(const std::string& file) {
    return file.ends_with(projectEnding) || holdsProject(file).value_or(false);
}

LoadedCity loadProjectCity(const Project& project, const std::string& file) {
    LoadedCity loaded;
    loaded.files = {file};
    loaded.inputs = project.inputs;
    loaded.settings = project.reading->settings;
    loaded.read.city = *project.city;
    loaded.read.format = "Noonmark project";
    loaded.read.features = project.city->buildings.size();
    loaded.read.attribution = project.attribution;
    loaded.read.warnings = project.reading->warnings;
    loaded.read.heights = project.reading->heights;
    return loaded;
}

namespace {

void addSamplePlaces(Project& project, const LoadedCity& loaded) {
    if (loaded.files.size() != 1 || !isParkSample(loaded.files.front())) return;
    Region park = centralParkRegion(*project.city);
    park.name = "Park";
    project.regions.push_back(std::move(park));
    for (const CaseStudyLot& lot : listCaseStudyLots(*project.city))
        project.lots.push_back({lot.tower, lot.ground});
}

}  // namespace

Project projectOf(const LoadedCity& loaded) {
    Project project;
    City city = makeIdsUnique(loaded.read.city);
    project.city = std::make_shared<const City>(std::move(city));
    project.attribution = loaded.read.attribution;
    project.inputs = loaded.inputs;
    project.reading = std::make_shared<const CityReading>(
        CityReading{loaded.settings, loaded.read.warnings, loaded.read.heights});
    addSamplePlaces(project, loaded);
    return project;
}

}  // namespace noonmark
