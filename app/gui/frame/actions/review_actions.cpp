#include "app/gui/frame/actions/review_actions.h"

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/make_action.h"
#include "app/gui/docks/review/glazing/glazing_session.h"
#include "app/gui/docks/review/review_dock.h"
#include "app/gui/docks/review/verdict_words.h"
#include "app/gui/docks/sheets/page_settings.h"
#include "app/gui/docks/sheets/sheets_dialog.h"
#include "app/gui/frame/actions/place_actions.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/preview/edit_preview.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/report/files/glazing_files.h"

namespace noonmark {

ReviewActions::ReviewActions(Workbench& workbench, ReviewSession& review, GlazingSession& windows,
                             ReviewDock& dock, EditPreview& preview, PlaceActions& places, ViewPanel& panel,
                             QSettings& settings, QWidget& window)
    : workbench_(workbench),
      review_(review),
      windows_(windows),
      panel_(panel),
      settings_(settings),
      window_(window),
      show_(makeAction(this, tr("Re&view by a rule..."), QKeySequence(tr("Ctrl+Shift+R")),
                       tr("Evaluate the rule of a review board on the places of the project"), "review")),
      export_(makeAction(this, tr("S&heets of the review..."), {},
                         tr("Shows the sheets of the review, and writes them with its tables and drawings"),
                         "sheets")) {
    show_->setObjectName(QStringLiteral("reviewByRule"));
    connect(show_, &QAction::triggered, this, &ReviewActions::dockWanted);
    connect(export_, &QAction::triggered, this, &ReviewActions::exportReview);
    connect(&dock, &ReviewDock::exportRequested, this, &ReviewActions::exportReview);
    connect(&workbench_, &Workbench::projectOpened, this, &ReviewActions::closeSheets);
    connect(&dock, &ReviewDock::placePointedAt, &panel_, &ViewPanel::highlightPlace);
    connect(&dock, &ReviewDock::zoomRequested, &places, &PlaceActions::zoomTo);
    connect(&review_, &ReviewSession::failed, &panel_.messages(), &MessageBar::showError);
    connect(&windows_, &GlazingSession::failed, &panel_.messages(), &MessageBar::showError);
    connect(&windows_, &GlazingSession::written, &panel_.messages(), [this](const QString& folder) {
        panel_.messages().showNote(tr("The review was exported to %1").arg(folder));
    });
    connect(&review_, &ReviewSession::noted, &panel_.messages(), &MessageBar::showNote);
    connect(&preview, &EditPreview::shapeChanged, &review_, &ReviewSession::shape);
    connect(&review_, &ReviewSession::answered, this, [this, &preview] { tellVerdicts(preview); });
}

// On the building that is being shaped.
void ReviewActions::tellVerdicts(EditPreview& preview) const {
    if (!review_.isLive()) return preview.setVerdicts({});
    const ReviewStudy& study = review_.shown()->study;
    preview.setVerdicts(tr("%1: %2").arg(QString::fromStdString(study.rule.name), describeVerdicts(study)));
}

void ReviewActions::closeSheets() { delete sheets_; }

void ReviewActions::exportReview() { windows_.applies() ? exportGlazing() : showSheets(); }

void ReviewActions::exportGlazing() {
    const auto answer = windows_.finished();
    if (!answer) return panel_.messages().showError(answer.error());
    const QString folder = askForFolder(&window_, tr("Export the review"));
    if (folder.isEmpty()) return;
    if (mayReplace(&window_, folder, filesInTheWay(folder, glazingFileNames())))
        windows_.write(*answer, folder, panel_.legend().choice());
}

void ReviewActions::showSheets() {
    auto answer = review_.finished();
    if (!answer) return panel_.messages().showError(answer.error());
    closeSheets();
    sheets_ =
        new SheetsDialog(*std::move(answer), review_.source(), workbench_.session(),
                         {.setup = readPageSetup(settings_), .legend = panel_.legend().choice()}, &window_);
    connect(sheets_, &SheetsDialog::failed, &panel_.messages(), &MessageBar::showError);
    connect(sheets_, &SheetsDialog::written, &panel_.messages(), [this](const QString& folder) {
        panel_.messages().showNote(tr("The review was exported to %1").arg(folder));
    });
    connect(sheets_, &SheetsDialog::setupChosen, this,
            [this](const PageSetup& setup) { savePageSetup(setup, settings_); });
    sheets_->show();
}

}  // namespace noonmark
