#include "core/study/provenance/provenance_texts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/version.h"
#include "core/io/settings/read_settings.h"
#include "core/simd/instruction_set.h"

namespace noonmark {

nlohmann::ordered_json inputsJson(const std::vector<InputFile>& inputs) {
    using Json = nlohmann::ordered_json;
    Json json = Json::array();
    for (const InputFile& input : inputs) {
        const bool made = input.sha256.empty();
        json.push_back({{"path", input.path.string()},
                        {"bytes", made ? Json() : Json(input.bytes)},
                        {"sha256", made ? Json() : Json(input.sha256)}});
    }
    return json;
}

namespace {

using Json = nlohmann::ordered_json;

Json textOrNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json projectJson(const ProjectRecord& project) {
    return {{"file", textOrNull(project.file)},
            {"file_sha256", textOrNull(project.fileSha256)},
            {"saved_as_measured", project.saved()},
            {"content_sha256", project.contentSha256},
            {"content_sha256_of", contentHashText}};
}

void addScenario(Json& json, const std::string& role, const ScenarioRecord& scenario) {
    json[role] = scenario.name;
    json[role + "_edits"] = scenario.edits;
    json[role + "_city_sha256"] = scenario.citySha256;
}

Json readSettingsJson(const std::optional<ReadSettings>& reading) {
    if (!reading) return nullptr;
    const std::string text = formatText(*reading);
    return text.empty() ? Json::object() : Json::parse(text);
}

}  // namespace

void addProvenance(Json& json, const Provenance& provenance) {
    const auto& project = provenance.project;
    json["project"] = project ? projectJson(*project) : Json();
    if (project) addScenario(json, "scenario", project->scenario);
    if (project && project->baseline) addScenario(json, "baseline", *project->baseline);
    json["inputs"] = inputsJson(provenance.inputs);
    json["read_settings"] = readSettingsJson(provenance.reading);
    json["attribution"] = provenance.attribution;
}

void addRepeat(Json& json, const Result<std::string>& command) {
    json["repeat"] = command ? Json(*command) : Json();
    if (!command) json["repeat_note"] = command.error().text();
}

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

SourceValues sourceValues(const Provenance& provenance) {
    if (!provenance.project) return {};
    const ProjectRecord& project = *provenance.project;
    return {project.file, project.scenario.name, project.baseline ? project.baseline->name : std::string(),
            project.contentSha256};
}

std::vector<std::string> withSourceColumns(std::vector<std::string> columns) {
    columns.insert(columns.end(), sourceColumnNames.begin(), sourceColumnNames.end());
    return columns;
}

void addSource(CsvText& csv, const SourceValues& source) {
    for (const std::string& value : source) csv.text(value);
}

}  // namespace noonmark
