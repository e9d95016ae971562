#include "app/gui/session/project/project_saving.h"

#include <QDir>
#include <atomic>
#include <mutex>
#include <utility>

#include "app/gui/session/project/project_session.h"
#include "app/input/load_city.h"

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
std::optional<fs::path> moveAside(const fs::path& recovery) {
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
        left_ = moveAside(recoveryPath(file_));
    }
}

void RecoveryStore::forgetLeft() {
    if (left_) removeProject(*std::exchange(left_, std::nullopt));
}

/// A recovery file that one thread writes and another may discard; nothing is written after that. Discarding
/// does not wait for a write: the file is removed when the write ends.
class RecoveredWork {
public:
    explicit RecoveredWork(const fs::path& file) : autosave_(file) {
        std::error_code none;
        movedAside_ = fs::exists(recoveryPath(file), none);
        if (movedAside_) moveProject(recoveryPath(file), ProjectSaving::olderRecovery(file));
    }

    /// Whether there was a recovery file of an earlier run; it has been moved to olderRecovery().
    [[nodiscard]] bool movedAside() const { return movedAside_; }

    Result<void> keep(const Project& project) {
        Result<void> saved = saveUnlessDiscarded(project);
        if (gone_) removeUnlessWritten();
        return saved;
    }

    void discard() {
        gone_ = true;
        removeUnlessWritten();
    }

private:
    Result<void> saveUnlessDiscarded(const Project& project) {
        const std::scoped_lock lock(mutex_);
        return gone_ ? Result<void>() : autosave_.keep(project);
    }

    void removeUnlessWritten() {
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (lock) autosave_.discard();
    }

    std::mutex mutex_;
    Autosave autosave_;
    std::atomic<bool> gone_ = false;
    bool movedAside_ = false;
};

ProjectSaving::ProjectSaving(ProjectSession& session, std::function<Compose()> capture, fs::path unsavedFile,
                             QObject* parent)
    : QObject(parent), session_(session), capture_(std::move(capture)), unsavedFile_(std::move(unsavedFile)) {
    timer_.setSingleShot(true);
    timer_.setInterval(autosaveMs);
    connect(&timer_, &QTimer::timeout, this, &ProjectSaving::writeRecovery);
    connect(&session_, &ProjectSession::unsavedChanged, this, [this] {
        if (session_.hasUnsavedWork() && !timer_.isActive()) timer_.start();
    });
}

// The later save waits: concurrent saves would each see the other as a change of the file by another program.
void ProjectSaving::save() {
    if (!session_.file()) return;
    if (writing_.busy()) return void(next_ = [this] { save(); });
    write(session_.file()->path(),
          [file = *session_.file(), compose = capture_()]() mutable -> Result<ProjectFile> {
              return file.save(compose()).map([&] { return std::move(file); });
          });
}

void ProjectSaving::saveAs(const fs::path& file) {
    if (writing_.busy()) return void(next_ = [this, file] { saveAs(file); });
    write(file, [file, compose = capture_()]() -> Result<ProjectFile> {
        const Project project = compose();
        return checkOutput(file, OutputKind::project, outputRules({}, project.inputs, true)).and_then([&] {
            return ProjectFile::create(file, project, ProjectFile::IfExists::replace);
        });
    });
}

void ProjectSaving::write(const fs::path& file, Write work) {
    writing_.start<ProjectFile>(
        tr("Saving %1").arg(QString::fromStdString(file.filename().string())),
        [work = std::move(work)](Progress&, std::stop_token) mutable { return work(); },
        [this, version = session_.version()](Result<ProjectFile> written) {
            take(std::move(written), version);
        });
}

void ProjectSaving::take(Result<ProjectFile> written, int version) {
    if (!written) {
        next_ = nullptr;
        return Q_EMIT failed(written.error());
    }
    removeRecovery();
    recovery_.clear();
    session_.setSaved(*std::move(written), version);
    removeProject(olderRecovery(session_.file()->path()));  // superseded by this save
    Q_EMIT saved(QString::fromStdString(session_.file()->path().string()));
    if (const auto next = std::exchange(next_, nullptr)) next();
}

fs::path ProjectSaving::savedBeside() const {
    return session_.file() ? session_.file()->path() : unsavedFile_;
}

fs::path ProjectSaving::olderRecovery(const fs::path& file) {
    return recoveryPath(file).replace_filename(recoveryPath(file).filename().string() + ".older" +
                                               projectEnding);
}

void ProjectSaving::writeRecovery() {
    if (!session_.hasUnsavedWork() || savedBeside().empty()) return;
    if (recoveryJob_.busy() || writing_.busy() || !leaving_.expired()) return timer_.start();
    if (!saved_) saved_ = std::make_shared<RecoveredWork>(savedBeside());
    recoveryJob_.start<bool>(
        tr("Saving recovery file"),
        [saved = saved_, compose = capture_()](Progress&, std::stop_token) {
            return saved->keep(compose()).map([] { return true; });
        },
        [this](const Result<bool>& saved) {
            if (!saved) Q_EMIT notSaved(saved.error());
        });
}

void ProjectSaving::removeRecovery() {
    if (saved_) {
        saved_->discard();
        leaving_ = saved_;
    }
    startOver();
}

void ProjectSaving::discardUnsaved() {
    if (!recovery_.empty() && session_.file()) deleteAdoptedRecovery();
    recovery_.clear();
    removeRecovery();
}

// If this run has written a recovery file, the newer of the earlier files was moved over the older one.
void ProjectSaving::deleteAdoptedRecovery() {
    const fs::path recovery = recoveryPath(session_.file()->path());
    const fs::path older = olderRecovery(session_.file()->path());
    const bool moved = saved_ && saved_->movedAside();
    if (recovery_ == recovery) removeProject(moved ? older : recovery);
    if (recovery_ == older && !moved) removeProject(older);
}

void ProjectSaving::projectReplaced() {
    next_ = nullptr;
    recovery_.clear();
    writing_.drop();
    startOver();
    if (session_.hasUnsavedWork()) timer_.start();
}

void ProjectSaving::startOver() {
    timer_.stop();
    recoveryJob_.drop();
    saved_.reset();
}

}  // namespace noonmark
