#pragma once

#include <QLockFile>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

namespace noonmark {

/// The recovery file of a project that was never saved. Its name in a folder is used by no other running
/// window. Work that an earlier run left under that name is moved aside and offered for recovery, the newest
/// first, then the one before. If there are `maxLeft` already, the oldest is removed. Recovered work that is
/// then saved or discarded is removed and not offered again.
class RecoveryStore {
public:
    static constexpr int maxLeft = 5;

    explicit RecoveryStore(const QString& folder);  ///< created if missing

    /// The name that the project would have (Autosave derives the recovery file's name from it); empty if the
    /// folder is not writable.
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

    /// Work that an earlier run left, until forgetLeft().
    [[nodiscard]] const std::optional<std::filesystem::path>& left() const { return left_; }
    void forgetLeft();

private:
    std::filesystem::path file_;
    std::optional<std::filesystem::path> left_;
    std::unique_ptr<QLockFile> lock_;
};

}  // namespace noonmark
