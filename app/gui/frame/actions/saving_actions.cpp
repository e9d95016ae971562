#include "app/gui/frame/actions/saving_actions.h"

#include <QDateTime>
#include <QFileInfo>
#include <QMessageBox>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/session/workbench.h"

namespace noonmark {

RecoveryOffers::RecoveryOffers(Workbench& workbench, const RecoveryStore& store, SavingActions& saving,
                               MessageBar& messages)
    : workbench_(workbench), store_(store), saving_(saving), messages_(messages) {}

void RecoveryOffers::offer() {
    const auto& file = workbench_.session().file();
    if (!file) return offerUnsavedProject();
    const auto found = recoveryOf(file->path());
    if (!found) return offerOlder();
    offerNewest(file->path(), *found);
}

void RecoveryOffers::offerNewest(const std::filesystem::path& project, const Recovery& found) {
    messages_.showHelp(tr("Noonmark closed before %1 was saved. Unsaved changes can be recovered.")
                           .arg(workbench_.projectName()));
    messages_.offer(tr("Recover"), [this, project, found] {
        std::error_code removed;
        const bool moved = std::filesystem::last_write_time(found.path, removed) != found.at;
        workbench_.recover(moved || removed ? ProjectSaving::olderRecovery(project) : found.path);
    });
    if (std::filesystem::exists(ProjectSaving::olderRecovery(project)))
        messages_.offerSecond(tr("Older changes..."), [this] { offerOlder(); });
}

// Offers an older recovery file, which was moved aside when a newer one was written.
void RecoveryOffers::offerOlder() {
    const auto& file = workbench_.session().file();
    if (!file) return;
    const std::filesystem::path older = ProjectSaving::olderRecovery(file->path());
    const QFileInfo info(QString::fromStdString(older.string()));
    if (!info.exists()) return;
    messages_.showHelp(
        tr("There are unsaved changes to %1 from %2. They can be recovered or deleted.")
            .arg(workbench_.projectName(), info.lastModified().toString(QStringLiteral("yyyy-MM-dd HH:mm"))));
    messages_.offer(tr("Recover"), [this, older] { workbench_.recover(older); });
    messages_.offerSecond(tr("Delete them"), [older] { removeProject(older); });
}

// Not where the open project is itself recovered work.
void RecoveryOffers::offerUnsavedProject() {
    if (!store_.left() || workbench_.session().recovered()) return;
    messages_.showHelp(
        tr("Noonmark closed before a project was saved. The unsaved project can be recovered."));
    messages_.offer(tr("Recover"),
                    [this] { saving_.whenSafe([this] { workbench_.recoverUntitled(*store_.left()); }); });
}

SavingActions::SavingActions(Workbench& workbench, RecoveryStore& store,
                             std::function<ProjectSaving::Compose()> capture, MessageBar& messages,
                             QWidget& window)
    : workbench_(workbench),
      store_(store),
      messages_(messages),
      window_(window),
      saving_(workbench.session(), std::move(capture), store.file()),
      save_(makeAction(this, tr("&Save project"), QKeySequence::Save,
                       tr("City, scenarios, lots, results and view in one file"), "save")),
      saveAs_(makeAction(this, tr("Save project &as..."), QKeySequence(tr("Ctrl+Shift+S")), {}, "save-as")),
      askUnsaved_([this] { return askUnsaved(); }),
      askSaveAs_([this](const QString& suggested) { return askForProject(&window_, suggested); }) {
    connectSaving();
}

void SavingActions::connectSaving() {
    connect(save_, &QAction::triggered, this, &SavingActions::save);
    connect(saveAs_, &QAction::triggered, this, &SavingActions::saveAs);
    connect(&saving_, &ProjectSaving::saved, this, &SavingActions::takeSaved);
    connect(&saving_, &ProjectSaving::failed, this, &SavingActions::showFailure);
    connect(&saving_, &ProjectSaving::notSaved, &messages_, &MessageBar::showError);
    connect(&workbench_, &Workbench::recovered, &saving_, &ProjectSaving::setRecovery);
    // The work discarded for a file that did not open is still open.
    connect(&workbench_, &Workbench::openFailed, this, &SavingActions::writeRecovery);
}

void SavingActions::takeSaved(const QString& file) {
    Q_EMIT saved(file);
    if (std::exchange(isRecovered_, false)) store_.forgetLeft();
    messages_.showNote(tr("Saved as %1").arg(file));
    if (const auto then = std::exchange(afterSave_, nullptr)) then();
}

void SavingActions::showFailure(const Error& error) {
    afterSave_ = nullptr;
    messages_.showError(error);
    messages_.offer(tr("Save as..."), [this] { saveAs(); });
}

void SavingActions::save() {
    if (!workbench_.session().file()) return saveAs();
    saving_.save();
}

void SavingActions::saveAs() {
    if (!workbench_.city()) return messages_.showError(noCityError());
    const QString file = askSaveAs_(workbench_.projectName() + QLatin1String(projectEnding));
    if (file.isEmpty()) return void(afterSave_ = nullptr);
    saveTo(file.toStdString());
}

void SavingActions::saveTo(const std::filesystem::path& file) { saving_.saveAs(file); }

bool SavingActions::confirmUnsaved(const std::function<void()>& afterSave) {
    afterSave_ = nullptr;
    if (!workbench_.session().hasUnsavedWork() && runningWork().isEmpty()) {
        saving_.removeRecovery();
        return true;
    }
    const Unsaved answer = askUnsaved_();
    if (answer == Unsaved::discard) discardWork();
    if (answer != Unsaved::save) return answer == Unsaved::discard;
    afterSave_ = afterSave;
    save();
    return false;
}

void SavingActions::whenSafe(const std::function<void()>& then) {
    if (confirmUnsaved([this, then] { whenSafe(then); })) then();
}

// Also removes the recovery file that the work came from; otherwise it would be offered again.
void SavingActions::discardWork() {
    saving_.discardUnsaved();
    if (std::exchange(isRecovered_, false)) store_.forgetLeft();
}

void SavingActions::takeProject() {
    afterSave_ = nullptr;
    saving_.projectReplaced();
    isRecovered_ = workbench_.session().recovered();
}

void SavingActions::watch(JobSlot& slot, std::function<bool()> isAwaited) {
    watched_[&slot] = {std::move(isAwaited), {}};
    connect(&slot, &JobSlot::started, this,
            [this, &slot](const Job&, const QString& what) { watched_[&slot].what = what; });
}

// Empty: none.
QString SavingActions::runningWork() const {
    for (const auto& [slot, watched] : watched_)
        if (slot->busy() && watched.isAwaited()) return watched.what;
    return {};
}

SavingActions::Unsaved SavingActions::askRunning() {
    QMessageBox box(QMessageBox::Question, tr("Work in progress"),
                    tr("%1 is still running. Stop it?").arg(runningWork()), QMessageBox::Cancel, &window_);
    const auto* stop = box.addButton(tr("Stop it"), QMessageBox::DestructiveRole);
    box.exec();
    return box.clickedButton() == stop ? Unsaved::discard : Unsaved::cancel;
}

SavingActions::Unsaved SavingActions::askUnsaved() {
    if (!workbench_.session().hasUnsavedWork()) return askRunning();
    const QString running = runningWork();
    const QString stopped =
        running.isEmpty() ? QString()
                          : QLatin1Char(' ') + tr("%1 is still running and will be stopped.").arg(running);
    const auto answer = QMessageBox::question(
        &window_, tr("Unsaved changes"), tr("Save changes to %1?").arg(workbench_.projectName()) + stopped,
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save) return Unsaved::save;
    return answer == QMessageBox::Discard ? Unsaved::discard : Unsaved::cancel;
}

}  // namespace noonmark
