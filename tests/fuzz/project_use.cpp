#include "tests/fuzz/project_use.h"

#include "scenarios/project/project_file.h"
#include "scenarios/project/results/saved_answer.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

namespace noonmark::tests {

namespace {

void useResults(const Project& project) {
    for (const auto& result : project.results) {
        for (const SavedLayer& layer : result->layers)
            require(layer.values.size() == result->grid.size(), "a layer has the grid's size");
        if (const auto answer = readSavedAnswer(*result); !answer) requireSound(answer.error());
    }
}

void useAreas(const Project& project) {
    for (const NamedLot& lot : project.lots) requireSound(std::vector{lot.outline});
    for (const Region& region : project.regions) requireSound(region.polygons);
}

void saveWithOneMore(ProjectFile& file) {
    Project project = file.project();
    project.scenarios.push_back({"one more", "", {}});
    if (!file.save(project)) return;
    const auto again = ProjectFile::open(file.path());
    require(again && again->project().scenarios.size() == project.scenarios.size(),
            "a project that was saved opens again");
}

}  // namespace

void useProject(const std::filesystem::path& file, Save save) {
    auto opened = ProjectFile::open(file);
    if (!opened) return requireSound(opened.error());
    const Project& project = opened->project();
    requireSound(*project.city);
    useAreas(project);
    useResults(project);
    for (const Scenario& scenario : project.scenarios)
        if (const auto edited = cityOf(project, scenario.name); edited) requireSound(edited->city);
    if (save == Save::yes) saveWithOneMore(*opened);
}

}  // namespace noonmark::tests
