#include "core/study/provenance/source_columns.h"

namespace noonmark {

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
