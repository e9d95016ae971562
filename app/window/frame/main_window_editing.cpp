#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QStatusBar>

#include "app/window/frame/main_window.h"
#include "app/window/project/project_dock.h"
#include "app/window/view/view_panel.h"

// The part of MainWindow that connects the edit tools to the project: each edit becomes an undo step.
namespace noonmark {

namespace {

constexpr int hintMs = 10000;

}  // namespace

void MainWindow::connectEditing() {
    menus_.edit->addSeparator();
    for (QAction* action : tools_.actions()) menus_.edit->addAction(action);
    connect(&tools_, &EditTools::editsMade, this,
            [this](const std::vector<Edit>& edits, const QString& what) {
                if (!workbench_.session().addEdits(edits, what)) tools_.takeBack();
            });
    connect(&tools_, &EditTools::lotDrawn, this,
            [this](const NamedLot& lot) { workbench_.session().addLot(lot); });
    connect(docks_.project, &ProjectDock::drawLotRequested, &tools_, &EditTools::drawLot);
    connect(&workbench_.session(), &ProjectSession::changed, this,
            [this] { tools_.setLots(workbench_.session().project().lots); });
    connect(&mode_, &ModeSwitch::changed, this, &MainWindow::askLive);
    connect(&workbench_, &Workbench::projectOpened, this, [this] { horizons_->forget(); });
    connect(&tools_.context().preview, &EditPreview::shownChanged, this, &MainWindow::showOutdated);
    connect(&tools_, &EditTools::failed, &panel_->messages(), &MessageBar::showError);
    // In the status bar, since the message bar would move the view under the cursor.
    connect(&tools_, &EditTools::hinted, this,
            [this](const QString& text) { statusBar()->showMessage(text, hintMs); });
    connect(&tools_, &EditTools::selectionMade, this, [this] { raiseDock(tools_.dock()); });
    connect(&tools_, &EditTools::designBegan, this, [this] { raiseDock(tools_.massingDock()); });
}

// In analysis and ray reference modes the live shadow uses the cells of the study.
void MainWindow::askLive() {
    if (!workbench_.city()) return;
    const StudySettings& settings = workbench_.document().settings();
    tools_.setQuestion({{settings.period, makeObserver(workbench_.city()->city(), settings)},
                        settings.region,
                        settings.receivers,
                        mode_.mode() != ViewMode::exploration});
}

// Raises the dock among its tabs. A dock that the user closed stays closed.
void MainWindow::raiseDock(const QWidget* content) {
    for (QDockWidget* dock : findChildren<QDockWidget*>())
        if (dock->isAncestorOf(content)) dock->raise();
}

}  // namespace noonmark
