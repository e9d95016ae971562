#pragma once

#include <QLockFile>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>

namespace noonmark {

/// Where the recovery file of a project that was never saved lies: a name in a folder that no other running
/// window uses. Work that an earlier run left under that name is put aside, to be taken up again: the newest
/// first, then the one before. Of `mostLeft` the oldest makes way for a newer one. What was taken up and then
/// saved or discarded is forgotten: the file goes, and is never offered again.
class RecoveryStore {
public:
    static constexpr int mostLeft = 5;

    explicit RecoveryStore(const QString& folder);  ///< made where it is not there

    /// The name that the project would have (Autosave knows the recovery file's); empty where the folder
    /// cannot be written.
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

    /// What an earlier run left, until it is forgotten.
    [[nodiscard]] const std::optional<std::filesystem::path>& left() const { return left_; }
    void forgetLeft();

private:
    std::filesystem::path file_;
    std::optional<std::filesystem::path> left_;
    std::unique_ptr<QLockFile> lock_;
};

}  // namespace noonmark
