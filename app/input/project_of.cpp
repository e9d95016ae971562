#include "app/input/project_of.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/city/trees/tree.h"
#include "core/samples/sample_city.h"
#include "scenarios/edits/building_ids.h"

namespace noonmark {

namespace {

void addSamplePlaces(Project& project, const LoadedCity& loaded) {
    if (loaded.files.size() != 1 || !isParkSample(loaded.files.front())) return;
    Region park = centralParkRegion(*project.city);
    park.name = "Park";
    project.regions.push_back(std::move(park));
    for (const CaseStudyLot& lot : listCaseStudyLots(*project.city))
        project.lots.push_back({lot.tower, lot.ground});
}

constexpr std::string_view whyNoTrees =
    "projects do not hold them; all questions measure the shadow of buildings and terrain only";

// A project has no table of trees: what it is asked now and after it is saved must be the same.
void leaveOutTrees(City& city, Warnings& warnings) {
    std::ranges::move(warnOfTrees(city.trees, whyNoTrees), std::back_inserter(warnings));
    city.trees.reset();
}

}  // namespace

Project projectOf(const LoadedCity& loaded) {
    Project project;
    City city = makeIdsUnique(loaded.read.city);
    Warnings warnings = loaded.read.warnings;
    leaveOutTrees(city, warnings);
    project.city = std::make_shared<const City>(std::move(city));
    project.attribution = loaded.read.attribution;
    project.inputs = loaded.inputs;
    project.reading = std::make_shared<const CityReading>(
        CityReading{loaded.settings, std::move(warnings), loaded.read.heights});
    addSamplePlaces(project, loaded);
    return project;
}

}  // namespace noonmark
