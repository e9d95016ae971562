#include "tests/fuzz/project_use.h"

#include "scenarios/project/kept_answer.h"
#include "scenarios/project/project_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

namespace noonmark::tests {

namespace {

void useResults(const Project& project) {
    for (const auto& result : project.results) {
        for (const KeptLayer& layer : result->layers)
            require(layer.values.size() == result->grid.size(), "a layer has the grid's size");
        if (const auto answer = answerOf(*result); !answer) requireSound(answer.error());
    }
}

void useAreas(const Project& project) {
    for (const NamedLot& lot : project.lots) requireSound(std::vector{lot.outline});
    for (const Region& region : project.regions) requireSound(region.polygons);
}

}  // namespace

void useProject(const std::filesystem::path& file) {
    auto opened = ProjectFile::open(file);
    if (!opened) return requireSound(opened.error());
    Project project = opened->project();
    requireSound(*project.city);
    useAreas(project);
    useResults(project);
    for (const Scenario& scenario : project.scenarios)
        if (const auto edited = cityOf(project, scenario.name); edited) requireSound(edited->city);
    project.scenarios.push_back({"one more", "", {}});
    if (opened->save(project)) {
        const auto again = ProjectFile::open(file);
        require(again && again->project().scenarios.size() == project.scenarios.size(),
                "a project that was saved opens again");
    }
}

}  // namespace noonmark::tests
