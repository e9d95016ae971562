#include "core/study/provenance/source_columns.h"

#include "core/base/csv_field.h"

namespace noonmark {

SourceValues sourceValues(const Provenance& provenance) {
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

}  // namespace noonmark
