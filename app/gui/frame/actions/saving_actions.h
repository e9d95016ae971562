#pragma once

#include <QObject>
#include <functional>
#include <map>

#include "app/gui/session/project/project_saving.h"
#include "scenarios/project/project_file.h"

// The actions of the window. Each class owns the menu entries (QAction) of one subject, does what they ask of
// the workbench, and listens to the docks that ask for the same: opening, saving, recovery, edits, studies,
// regions, scenarios, results, view. They know neither the main window nor each other's entries; window_menus
// (frame) arranges them in menus.
class QAction;
class QWidget;

namespace noonmark {

class MessageBar;
class RecoveryStore;
class SavingActions;
class Workbench;

/// Offers the recovery files that earlier runs left for the open project, or for a project without a file.
class RecoveryOffers final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    RecoveryOffers(Workbench& workbench, const RecoveryStore& store, SavingActions& saving,
                   MessageBar& messages);

    void offer();  ///< what there is for the project that has been opened

private:
    void offerNewest(const std::filesystem::path& project, const Recovery& found);
    void offerOlder();
    void offerUnsavedProject();

    Workbench& workbench_;
    const RecoveryStore& store_;
    SavingActions& saving_;
    MessageBar& messages_;
};

/// Saves the project, and asks about unsaved work before an action that would lose it.
class SavingActions final : public QObject {
    Q_OBJECT
public:
    /// `capture` returns what is to be saved now; `store` names the recovery file of a project without a
    /// file; dialogs belong to `window`. All must outlive this object.
    SavingActions(Workbench& workbench, RecoveryStore& store, std::function<ProjectSaving::Compose()> capture,
                  MessageBar& messages, QWidget& window);

    [[nodiscard]] QList<QAction*> actions() const { return {save_, saveAs_}; }
    [[nodiscard]] JobSlot& writing() { return saving_.writing(); }
    void writeRecovery() { saving_.writeRecovery(); }  ///< writes the recovery file now

    void save();
    void saveAs();                                   ///< asks for a file
    void saveTo(const std::filesystem::path& file);  ///< replaces a project file, never another file
    /// Work that the user waits for, so that the user is asked before it is stopped; the slot must outlive
    /// this object. `isAwaited`: whether that which runs in it is such.
    void watch(JobSlot& slot, std::function<bool()> isAwaited);
    /// Whether an action that ends the current work may proceed now: nothing is unsaved or running, or the
    /// user discards it. False if the user cancels or saves first; in the latter case `afterSave` is called
    /// after the save. An action that waited for an earlier save is dropped.
    [[nodiscard]] bool confirmUnsaved(const std::function<void()>& afterSave);
    /// Calls `then` once no work can be lost: at once, after a save, or never.
    void whenSafe(const std::function<void()>& then);
    void takeProject();  ///< another project is open

    /// What to do with unsaved or running work before an action that would lose it; running work alone cannot
    /// be saved. Tests answer here instead of in a dialog.
    enum class Unsaved { save, discard, cancel };
    void setUnsavedQuestion(std::function<Unsaved()> question) { askUnsaved_ = std::move(question); }
    /// Replaces the "Save as" dialog: takes the suggested name, returns the file, or an empty string if the
    /// user cancelled.
    using SaveAsQuestion = std::function<QString(const QString& suggested)>;
    void setSaveAsQuestion(SaveAsQuestion question) { askSaveAs_ = std::move(question); }

    /// The recovery file of this window is not needed any more: another one keeps the work.
    void removeRecovery() { saving_.removeRecovery(); }

Q_SIGNALS:
    void saved(QString file);

private:
    void connectSaving();
    void takeSaved(const QString& file);
    void showFailure(const Error& error);
    void discardWork();
    [[nodiscard]] Unsaved askUnsaved();
    [[nodiscard]] Unsaved askRunning();
    [[nodiscard]] QString runningWork() const;

    Workbench& workbench_;
    RecoveryStore& store_;
    MessageBar& messages_;
    QWidget& window_;
    ProjectSaving saving_;
    QAction* save_;
    QAction* saveAs_;
    std::function<Unsaved()> askUnsaved_;
    struct Watched {
        std::function<bool()> isAwaited;
        QString what;  ///< that was started last
    };
    std::map<JobSlot*, Watched> watched_;
    SaveAsQuestion askSaveAs_;
    /// Action to continue with after the save that the user asked for.
    std::function<void()> afterSave_;
    /// The open project was recovered from work that an earlier run left unsaved.
    bool isRecovered_ = false;
};

}  // namespace noonmark
