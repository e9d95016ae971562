#include "app/window/actions/review_actions.h"

#include "app/report/files/review_files.h"
#include "app/window/actions/make_action.h"
#include "app/window/actions/place_actions.h"
#include "app/window/editing/edit_preview.h"
#include "app/window/frame/workbench.h"
#include "app/window/review/review_dock.h"
#include "app/window/view/view_panel.h"
#include "app/window/widgets/file_dialogs.h"

namespace noonmark {

ReviewActions::ReviewActions(Workbench& workbench, ReviewSession& review, ReviewDock& dock,
                             const EditPreview& preview, PlaceActions& places, ViewPanel& panel,
                             QWidget& window)
    : workbench_(workbench),
      review_(review),
      panel_(panel),
      window_(window),
      show_(makeAction(this, tr("Re&view by a rule..."), QKeySequence(tr("Ctrl+Shift+R")),
                       tr("Evaluate the rule of a review board on the places of the project"))),
      export_(makeAction(this, tr("E&xport review..."), {},
                         tr("The verdicts and the numbers behind them as JSON and CSV"))) {
    connect(show_, &QAction::triggered, this, &ReviewActions::dockWanted);
    connect(export_, &QAction::triggered, this, &ReviewActions::exportReview);
    connect(&dock, &ReviewDock::exportRequested, this, &ReviewActions::exportReview);
    connect(&dock, &ReviewDock::placePointedAt, &panel_, &ViewPanel::highlightPlace);
    connect(&dock, &ReviewDock::zoomRequested, &places, &PlaceActions::zoomTo);
    connect(&review_, &ReviewSession::failed, &panel_.messages(), &MessageBar::showError);
    connect(&review_, &ReviewSession::noted, &panel_.messages(), &MessageBar::showNote);
    connect(&preview, &EditPreview::shapeChanged, &review_, &ReviewSession::shape);
}

void ReviewActions::exportReview() {
    if (!review_.shown() || review_.isLive()) return review_.write({});  // refused, with the reason
    const QString folder = askForFolder(&window_, tr("Export review to folder"));
    if (folder.isEmpty()) return;
    QStringList there;
    for (const std::string& name : findExistingOutputs(folder.toStdString(), reviewFileNames()))
        there << QString::fromStdString(name);
    if (mayReplace(&window_, folder, there)) review_.write(folder.toStdString());
}

}  // namespace noonmark
