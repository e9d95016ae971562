#include "app/input/import_trees.h"

#include <algorithm>

#include "core/study/provenance/provenance.h"
#include "scenarios/edits/apply_edits.h"

namespace noonmark {

namespace {

// A file that was read before may have changed since.
void addInput(std::vector<InputFile>& inputs, const InputFile& input) {
    std::erase_if(inputs, [&](const InputFile& known) { return known.path == input.path; });
    inputs.push_back(input);
}

CityReading withTreeFiles(CityReading reading, const std::vector<std::filesystem::path>& files) {
    if (!reading.settings) return reading;
    std::vector<std::string>& named = reading.settings->treeFiles;
    for (const std::filesystem::path& file : files)
        if (std::ranges::find(named, file.string()) == named.end()) named.push_back(file.string());
    return reading;
}

std::size_t countTrees(const City& city) { return city.trees ? city.trees->trees.size() : 0; }

}  // namespace

Result<TreesImported> importTrees(Project project, const std::vector<std::filesystem::path>& files,
                                  const TreeReading& how, Progress& progress, const std::stop_token& stop) {
    City city = *project.city;
    TreesImported imported{.before = project.city};
    for (const std::filesystem::path& file : files) {
        auto read = readTrees(file, how, progress, stop);
        if (!read) return tl::make_unexpected(read.error());
        const auto inputs = describeInputFiles(file);
        if (!inputs) return tl::make_unexpected(inputs.error());
        for (const InputFile& input : *inputs) addInput(project.inputs, input);
        std::ranges::move(read->warnings, std::back_inserter(imported.warnings));
        city.trees = joinTrees(read->trees, city, ReadSettings{}.farAwayM, imported.warnings);
    }
    CityReading reading = how.fields.empty() ? withTreeFiles(*project.reading, files) : *project.reading;
    std::ranges::copy(imported.warnings, std::back_inserter(reading.warnings));
    project.reading = std::make_shared<const CityReading>(std::move(reading));
    imported.added = countTrees(city) - countTrees(*project.city);
    project.city = std::make_shared<const City>(makeIdsUnique(std::move(city)));
    imported.project = std::move(project);
    return imported;
}

}  // namespace noonmark
