#include "core/study/provenance/source_columns.h"

#include <fmt/format.h>

namespace noonmark {

std::string sourceFields(const Provenance& provenance) {
    if (!provenance.project) return ",,,,";
    const ProjectRecord& project = *provenance.project;
    return fmt::format(",{},{},{},{}", csvField(project.file), csvField(project.scenario.name),
                       project.baseline ? csvField(project.baseline->name) : std::string(),
                       project.contentSha256);
}

std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + '"';
}

}  // namespace noonmark
