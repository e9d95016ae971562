#pragma once

#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "app/gui/base/jobs/job.h"
#include "scenarios/project/project_file.h"

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

class RecoveredWork;
class ProjectSession;

/// Saves the session's project: into its file on request, and unsaved changes at intervals into the recovery
/// file beside it. Works in jobs, one save after the other.
class ProjectSaving final : public QObject {
    Q_OBJECT
public:
    /// Makes the project as it is saved, on another thread.
    using Compose = std::function<Project()>;
    /// `capture` returns what is to be saved now. `unsavedFile`: the recovery file of a project without a
    /// file is written beside this path; empty: it is not written. `session` must outlive this object.
    ProjectSaving(ProjectSession& session, std::function<Compose()> capture,
                  std::filesystem::path unsavedFile, QObject* parent = nullptr);

    void save();                                     ///< only if the session has a file
    void saveAs(const std::filesystem::path& file);  ///< replaces a project file, never another file
    /// Writes unsaved changes to the recovery file now; the timer calls it `autosaveMs` after a change. A
    /// recovery file of an earlier run is moved aside, not overwritten.
    void writeRecovery();
    /// Nothing is unsaved any more: removes this run's recovery file.
    void removeRecovery();
    /// Reports that the session contains the work of this recovery file of an earlier run.
    void setRecovery(const std::filesystem::path& recovery) { recovery_ = recovery; }
    /// The user discards unsaved work: removes this run's recovery file, and the one that the work was
    /// recovered from. A recovery file that was offered and not used stays.
    void discardUnsaved();
    /// Another project was opened: the previous project's recovery file stays. A save of it in progress
    /// completes silently; one that was waiting is dropped.
    void projectReplaced();

    [[nodiscard]] JobSlot& writing() { return writing_; }

    /// The path to which an earlier recovery file is moved before a new one is written; see writeRecovery().
    /// One per project, replacing an older one. The next save removes it, and so does discardUnsaved() after
    /// setRecovery() of it.
    [[nodiscard]] static std::filesystem::path olderRecovery(const std::filesystem::path& file);

    static constexpr int autosaveMs = 15000;

Q_SIGNALS:
    void saved(QString file);
    void failed(noonmark::Error error);
    void notSaved(noonmark::Error error);  ///< the recovery file could not be written

private:
    using Write = std::function<Result<ProjectFile>()>;
    void write(const std::filesystem::path& file, Write work);
    void take(Result<ProjectFile> written, int version);
    void startOver();
    [[nodiscard]] std::filesystem::path savedBeside() const;

    ProjectSession& session_;
    std::function<Compose()> capture_;
    std::filesystem::path unsavedFile_;
    std::shared_ptr<RecoveredWork> saved_;  // null: no recovery file written since the last save
    std::weak_ptr<RecoveredWork> leaving_;  // still being written when discarded
    std::function<void()> next_;            // a save requested while another was in progress
    void deleteAdoptedRecovery();

    std::filesystem::path recovery_;  // the recovery file whose work was taken up; empty: none
    QTimer timer_;
    JobSlot writing_;
    JobSlot recoveryJob_;
};

}  // namespace noonmark
