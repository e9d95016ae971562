#include "core/study/provenance/provenance_json.h"

#include "core/io/settings/read_settings_text.h"
#include "core/study/provenance/inputs_json.h"

namespace noonmark {

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

}  // namespace noonmark
