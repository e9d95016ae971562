#include "app/gui/frame/actions/recovery_offers.h"

#include <QDateTime>
#include <QFileInfo>

#include "app/gui/base/widgets/message_bar.h"
#include "app/gui/frame/actions/saving_actions.h"
#include "app/gui/session/workbench.h"
#include "scenarios/project/recovery_file.h"

namespace noonmark {

RecoveryOffers::RecoveryOffers(Workbench& workbench, const RecoveryStore& store, SavingActions& saving,
                               MessageBar& messages)
    : workbench_(workbench), store_(store), saving_(saving), messages_(messages) {}

void RecoveryOffers::offer() {
    const auto& file = workbench_.session().file();
    if (!file) return offerLeft();
    const auto found = recoveryOf(file->path());
    if (!found) return offerOlder();
    offerNewest(file->path(), *found);
}

void RecoveryOffers::offerNewest(const std::filesystem::path& project, const Recovery& found) {
    messages_.showHelp(tr("Noonmark closed before %1 was saved. Unsaved changes can be recovered.")
                           .arg(workbench_.projectName()));
    messages_.offer(tr("Recover"), [this, project, found] {
        std::error_code gone;
        const bool moved = std::filesystem::last_write_time(found.path, gone) != found.at;
        workbench_.recover(moved || gone ? ProjectSaving::olderRecovery(project) : found.path);
    });
    if (std::filesystem::exists(ProjectSaving::olderRecovery(project)))
        messages_.offerToo(tr("Older changes..."), [this] { offerOlder(); });
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
    messages_.offerToo(tr("Delete them"), [older] { removeProject(older); });
}

// Not where the open project is itself recovered work.
void RecoveryOffers::offerLeft() {
    if (!store_.left() || workbench_.session().recovered()) return;
    messages_.showHelp(
        tr("Noonmark closed before a project was saved. The unsaved project can be recovered."));
    messages_.offer(tr("Recover"),
                    [this] { saving_.whenSafe([this] { workbench_.recoverUntitled(*store_.left()); }); });
}

}  // namespace noonmark
