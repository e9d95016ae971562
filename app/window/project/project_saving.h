#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>

#include "app/window/study/job_slot.h"
#include "scenarios/project/recovery_file.h"

namespace noonmark {

class RecoveredWork;
class ProjectSession;

/// Writes the session's project: into its file when asked to, and what is not saved yet into the recovery
/// file beside it from time to time. Works beside the window; one save follows the other.
class ProjectSaving final : public QObject {
    Q_OBJECT
public:
    using View = std::map<std::string, std::string>;
    /// `view` says what to keep of the window. `unsavedFile`: beside it lies the recovery file of a project
    /// that has no file yet; empty: such a project is not kept. `session` outlives it.
    ProjectSaving(ProjectSession& session, std::function<View()> view, std::filesystem::path unsavedFile,
                  QObject* parent = nullptr);

    void save();                                     ///< only where the session has a file
    void saveAs(const std::filesystem::path& file);  ///< over a project, never another file
    /// What is not saved, now; as the timer does `autosaveMs` after a change. A recovery file of an earlier
    /// run is moved aside, not written over.
    void keepUnsaved();
    /// Nothing is unsaved any more: this run's recovery file goes.
    void forgetUnsaved();
    /// The session has taken up what this recovery file of an earlier run holds.
    void takeUp(const std::filesystem::path& recovery) { takenUp_ = recovery; }
    /// The user does not want the unsaved work: this run's recovery file goes, and the one that the work was
    /// taken up from. One that was offered and not taken up stays.
    void discardUnsaved();
    /// Another project was opened: what was kept of the one before stays. A save of that one still ends on
    /// the disk, unheard; one that waited is left out.
    void projectReplaced();

    [[nodiscard]] JobSlot& writing() { return writing_; }

    /// Where the recovery file lies that was there before this one's was written; see keepUnsaved(). One for
    /// each project, in place of an older one; the next save removes it, and so does discardUnsaved() after
    /// takeUp() of it.
    [[nodiscard]] static std::filesystem::path olderRecovery(const std::filesystem::path& file);

    static constexpr int autosaveMs = 15000;

Q_SIGNALS:
    void saved(QString file);
    void failed(noonmark::Error error);
    void notSaved(noonmark::Error error);  ///< the recovery file could not be written; the work goes on

private:
    using Write = std::function<Result<ProjectFile>()>;
    void write(const std::filesystem::path& file, Write work);
    void take(Result<ProjectFile> written, int version);
    void startOver();
    [[nodiscard]] std::filesystem::path savedBeside() const;

    ProjectSession& session_;
    std::function<View()> view_;
    std::filesystem::path unsavedFile_;
    std::shared_ptr<RecoveredWork> saved_;  // null: nothing was kept since the last save
    std::weak_ptr<RecoveredWork> leaving_;  // still being written when it was discarded
    std::function<void()> next_;            // a save that was asked for while another wrote
    void forgetTakenUp();

    std::filesystem::path takenUp_;  // empty: nothing
    QTimer timer_;
    JobSlot writing_;
    JobSlot keeping_;
};

}  // namespace noonmark
