#include "core/study/provenance/source_columns.h"

namespace noonmark {

std::array<std::string, sourceColumnNames.size()> sourceValues(const Provenance& provenance) {
    if (!provenance.project) return {};
    const ProjectRecord& project = *provenance.project;
    return {project.file, project.scenario.name, project.baseline ? project.baseline->name : std::string(),
            project.contentSha256};
}

std::string sourceFields(const Provenance& provenance) {
    std::string fields;
    for (const std::string& value : sourceValues(provenance)) {
        fields += ',';
        fields += csvField(value);
    }
    return fields;
}

std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + '"';
}

}  // namespace noonmark
