#include "app/window/project/unsaved_place.h"

#include <QDir>
#include <utility>

#include "scenarios/project/autosave.h"

namespace noonmark {

namespace fs = std::filesystem;

namespace {

constexpr int mostWindows = 50;

fs::path asideName(const fs::path& recovery, int number) {
    return recovery.string() + ".left" + (number > 1 ? std::to_string(number) : "") + projectEnding;
}

// Out of the way of this run's own recovery file and beside what was put aside before; the newest of all.
std::optional<fs::path> putAside(const fs::path& recovery) {
    std::error_code error;
    int unused = 1;
    while (fs::exists(asideName(recovery, unused), error)) ++unused;
    if (fs::exists(recovery, error)) {
        fs::rename(recovery, asideName(recovery, unused), error);
        if (!error) ++unused;
    }
    return unused > 1 ? std::optional(asideName(recovery, unused - 1)) : std::nullopt;
}

}  // namespace

UnsavedPlace::UnsavedPlace(const QString& folder) {
    if (!QDir().mkpath(folder)) return;
    for (int i = 1; i <= mostWindows && !lock_; ++i) {
        const QString name = QDir(folder).filePath(QStringLiteral("Untitled %1").arg(i));
        auto lock = std::make_unique<QLockFile>(name + QStringLiteral(".lock"));
        lock->setStaleLockTime(0);  // only a process that has ended leaves a stale lock
        if (!lock->tryLock(0)) continue;
        lock_ = std::move(lock);
        file_ = (name + QLatin1String(projectEnding)).toStdString();
        left_ = putAside(recoveryPath(file_));
    }
}

void UnsavedPlace::forgetLeft() {
    std::error_code ignored;
    if (left_) fs::remove(*std::exchange(left_, std::nullopt), ignored);
}

}  // namespace noonmark
