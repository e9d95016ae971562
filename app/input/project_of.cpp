#include "app/input/project_of.h"

#include "core/samples/sample_city.h"
#include "scenarios/edits/building_ids.h"

namespace noonmark {

namespace {

void addSamplePlaces(Project& project, const LoadedCity& loaded) {
    if (loaded.files != std::vector<std::string>{"sample:central-park-south"}) return;
    Region park = centralParkRegion(*project.city);
    park.name = "Park";
    project.regions.push_back(std::move(park));
    for (const CaseStudyLot& lot : listCaseStudyLots(*project.city))
        project.lots.push_back({lot.tower, lot.ground});
}

}  // namespace

Project projectOf(const LoadedCity& loaded) {
    Project project;
    project.city = std::make_shared<const City>(makeIdsUnique(loaded.read.city));
    project.attribution = loaded.read.attribution;
    project.inputs = loaded.inputs;
    project.reading = std::make_shared<const CityReading>(
        CityReading{loaded.settings, loaded.read.warnings, loaded.read.heights});
    addSamplePlaces(project, loaded);
    return project;
}

}  // namespace noonmark
