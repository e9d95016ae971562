#include "core/study/provenance/provenance_tags.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/version.h"
#include "core/simd/instruction_set.h"

namespace noonmark {

namespace {

void add(FileTags& tags, const std::string& name, const std::string& text) {
    if (!text.empty()) tags[name] = text;
}

void addScenario(FileTags& tags, const std::string& role, const ScenarioRecord& scenario) {
    add(tags, role, scenario.name);
    add(tags, role + "_EDITS", fmt::format("{}", fmt::join(scenario.edits, "\n")));
    add(tags, role + "_CITY_SHA256", scenario.citySha256);
}

void addProject(FileTags& tags, const ProjectRecord& project) {
    add(tags, "NOONMARK_PROJECT", project.file.empty() ? "never saved" : project.file);
    add(tags, "NOONMARK_PROJECT_SHA256", project.fileSha256);
    add(tags, "NOONMARK_PROJECT_CONTENT_SHA256", project.contentSha256);
    addScenario(tags, "NOONMARK_SCENARIO", project.scenario);
    if (project.baseline) addScenario(tags, "NOONMARK_BASELINE", *project.baseline);
}

std::string linesOf(const std::vector<InputFile>& inputs) {
    std::string text;
    for (const InputFile& input : inputs)
        text +=
            fmt::format("{}{} {}", text.empty() ? "" : "\n", input.sha256, input.path.filename().string());
    return text;
}

}  // namespace

FileTags makeProvenanceTags(const Provenance& provenance) {
    FileTags tags{{"NOONMARK_VERSION", std::string(version())},
                  {"NOONMARK_INSTRUCTION_SET", std::string(nameOf(instructionSetInUse()))}};
    if (provenance.project) addProject(tags, *provenance.project);
    add(tags, "NOONMARK_INPUTS", linesOf(provenance.inputs));
    add(tags, "NOONMARK_ATTRIBUTION", provenance.attribution);
    return tags;
}

}  // namespace noonmark
