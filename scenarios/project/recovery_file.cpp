#include "scenarios/project/recovery_file.h"

namespace noonmark {

namespace fs = std::filesystem;

fs::path recoveryPath(const fs::path& file) {
    std::string name = file.filename().string();
    if (name.ends_with(projectEnding)) name.resize(name.size() - std::string_view(projectEnding).size());
    return file.parent_path() / ("." + name + ".recovery" + projectEnding);
}

Result<void> Autosave::keep(const Project& project) {
    if (saved_) return saved_->save(project);
    auto made = ProjectFile::create(path_, project, ProjectFile::IfThere::replace);
    if (!made) return tl::make_unexpected(made.error());
    saved_ = *std::move(made);
    return {};
}

void Autosave::discard() {
    saved_.reset();
    std::error_code ignored;
    fs::remove(path_, ignored);
}

std::optional<Recovery> recoveryOf(const fs::path& file) {
    std::error_code error;
    const fs::path path = recoveryPath(file);
    if (!fs::exists(path, error)) return std::nullopt;
    const auto recovered = fs::last_write_time(path, error);
    const auto saved = fs::last_write_time(file, error);
    if (!error && saved > recovered) return std::nullopt;
    return Recovery{path, recovered};
}

}  // namespace noonmark
