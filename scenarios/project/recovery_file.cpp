#include "scenarios/project/recovery_file.h"

namespace noonmark {

namespace fs = std::filesystem;

namespace {

// What a save that was killed leaves beside the file: its last part, without which the file is torn.
fs::path journalOf(const fs::path& file) { return file.string() + "-journal"; }

}  // namespace

fs::path recoveryPath(const fs::path& file) {
    std::string name = file.filename().string();
    if (name.ends_with(projectEnding)) name.resize(name.size() - std::string_view(projectEnding).size());
    return file.parent_path() / ("." + name + ".recovery" + projectEnding);
}

void removeProject(const fs::path& file) {
    std::error_code ignored;
    fs::remove(file, ignored);
    fs::remove(journalOf(file), ignored);
}

void moveProject(const fs::path& from, const fs::path& to) {
    removeProject(to);
    std::error_code none;
    if (fs::exists(journalOf(from), none)) fs::rename(journalOf(from), journalOf(to), none);
    fs::rename(from, to, none);
}

Result<void> Autosave::keep(const Project& project) {
    if (saved_) return saved_->save(project);
    std::error_code none;
    fs::remove(journalOf(path_), none);  // of the file that is replaced now
    auto made = ProjectFile::create(path_, project, ProjectFile::IfThere::replace);
    if (!made) return tl::make_unexpected(made.error());
    saved_ = *std::move(made);
    return {};
}

void Autosave::discard() {
    saved_.reset();
    removeProject(path_);
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
