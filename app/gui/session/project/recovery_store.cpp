#include "app/gui/session/project/recovery_store.h"

#include <QDir>
#include <utility>

#include "scenarios/project/recovery_file.h"

namespace noonmark {

namespace fs = std::filesystem;

namespace {

constexpr int maxWindows = 50;

fs::path asideName(const fs::path& recovery, int number) {
    return recovery.string() + ".left" + (number > 1 ? std::to_string(number) : "") + projectEnding;
}

// The number of files moved aside. The oldest has number 1, and there are no gaps.
int countAside(const fs::path& recovery) {
    std::error_code none;
    int count = 0;
    while (fs::exists(asideName(recovery, count + 1), none)) ++count;
    return count;
}

void dropOldest(const fs::path& recovery, int count) {
    removeProject(asideName(recovery, 1));
    for (int i = 1; i < count; ++i) moveProject(asideName(recovery, i + 1), asideName(recovery, i));
}

// Moves an earlier run's recovery file aside, as the newest of those moved before. Returns the newest.
std::optional<fs::path> putAside(const fs::path& recovery) {
    std::error_code error;
    if (fs::exists(recovery, error)) {
        for (int count = countAside(recovery); count >= RecoveryStore::maxLeft; --count)
            dropOldest(recovery, count);
        moveProject(recovery, asideName(recovery, countAside(recovery) + 1));
    }
    const int count = countAside(recovery);
    return count > 0 ? std::optional(asideName(recovery, count)) : std::nullopt;
}

}  // namespace

RecoveryStore::RecoveryStore(const QString& folder) {
    if (!QDir().mkpath(folder)) return;
    for (int i = 1; i <= maxWindows && !lock_; ++i) {
        const QString name = QDir(folder).filePath(QStringLiteral("Untitled %1").arg(i));
        auto lock = std::make_unique<QLockFile>(name + QStringLiteral(".lock"));
        lock->setStaleLockTime(0);  // only a process that has ended leaves a stale lock
        if (!lock->tryLock(0)) continue;
        lock_ = std::move(lock);
        file_ = (name + QLatin1String(projectEnding)).toStdString();
        left_ = putAside(recoveryPath(file_));
    }
}

void RecoveryStore::forgetLeft() {
    if (left_) removeProject(*std::exchange(left_, std::nullopt));
}

}  // namespace noonmark
