#include "app/cli/verify/later_save.h"

#include "scenarios/project/project_provenance.h"

namespace noonmark::cli {

namespace {

std::string textAt(const nlohmann::ordered_json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// What of the project the record is about. Error: it has no such weight table.
Result<MeasuredPart> partOf(const Project& project, const nlohmann::ordered_json& record) {
    MeasuredPart part{textAt(record, "scenario"), textAt(record, "baseline"), {}, {}};
    const std::string weights = textAt(record, "weights");
    if (weights.empty()) return part;
    return findWeights(project, weights).map([&](TimeWeights table) {
        part.weights = std::move(table);
        return part;
    });
}

bool holdsContent(const std::filesystem::path& file, const nlohmann::ordered_json& record,
                  const std::string& contentSha256) {
    const auto disk = ProjectFile::open(file);
    if (!disk) return false;
    const auto part = partOf(disk->project(), record);
    if (!part) return false;
    const auto content = hashContent(disk->project(), *part);
    return content && *content == contentSha256;
}

}  // namespace

void acceptLaterSaves(std::vector<FoundFile>& files, const nlohmann::ordered_json& record) {
    const auto project = record.find("project");
    if (project == record.end() || !project->is_object()) return;
    const std::string fileSha256 = textAt(*project, "file_sha256"),
                      content = textAt(*project, "content_sha256");
    if (fileSha256.empty() || content.empty()) return;
    for (FoundFile& file : files) {
        if (file.agrees || !file.path || file.recorded.sha256 != fileSha256) continue;
        file.isSavedAgain = file.agrees = holdsContent(*file.path, record, content);
    }
}

}  // namespace noonmark::cli
