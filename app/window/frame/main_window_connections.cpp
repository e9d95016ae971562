#include <QAction>
#include <QMenu>
#include <QUndoStack>
#include <glm/common.hpp>

#include "app/window/frame/main_window.h"
#include "app/window/study/open_options.h"
#include "app/window/study/study_dock.h"
#include "app/window/study/warning_place.h"
#include "app/window/study/warnings_dock.h"
#include "app/window/view/view_panel.h"
#include "app/window/widgets/file_dialogs.h"
#include "app/window/widgets/progress_strip.h"

// The part of MainWindow that connects menus, docks and view to the workbench.
namespace noonmark {

void MainWindow::connectJobs() {
    progress_->follow(workbench_.opening());
    // Not cancellable: the view would show a scenario other than the one selected in the tree.
    progress_->follow(workbench_.following(), ProgressStrip::Jobs::whole);
    for (JobSlot* slot : {&workbench_.reading(), &workbench_.writing(), &saving_.writing()})
        progress_->follow(*slot);
    for (JobSlot* slot : {&workbench_.keeping(), &tools_.context().preview.working(), &looking_.working()})
        progress_->follow(*slot, ProgressStrip::Jobs::often);
    docks_.study->progress().follow(workbench_.running());
    connect(&workbench_.running(), &JobSlot::started, docks_.study, [this] {
        docks_.study->setRunning(true);
        mode_.showStudies();
    });
    connect(&workbench_.running(), &JobSlot::ended, docks_.study,
            [this] { docks_.study->setRunning(false); });
}

void MainWindow::connectWorkbench() {
    connect(&workbench_, &Workbench::cityShown, this, &MainWindow::showCity);
    connect(&workbench_, &Workbench::projectOpened, this, &MainWindow::showProject);
    connect(&workbench_, &Workbench::studyDone, this, [this] {
        panel_->messages().dismiss();
        showStudy();
    });
    connect(&workbench_, &Workbench::studyPartial, this,
            [this](const auto& partial) { panel_->results().setPartial(partial); });
    connect(&workbench_, &Workbench::studyStopped, this, &MainWindow::showStopped);
    connect(&workbench_, &Workbench::failed, &panel_->messages(), &MessageBar::showError);
    connect(&workbench_, &Workbench::noted, &panel_->messages(), &MessageBar::showNote);
    connect(&workbench_.document(), &StudyDocument::changed, this, &MainWindow::showDocument);
    connect(docks_.warnings, &WarningsDock::placeChosen, this, &MainWindow::goToPlace);
}

void MainWindow::connectFileMenu() {
    const auto opens = [this](QAction* action, const char* sample) {
        connect(action, &QAction::triggered, this, [this, sample] { open({QString::fromLatin1(sample)}); });
    };
    opens(menus_.openPark, "sample:central-park-south");
    opens(menus_.openGrid, "sample:grid");
    for (QAction* action : {menus_.newProject, menus_.open})
        connect(action, &QAction::triggered, this, [this] { open(askForCity(this)); });
    connect(&recent_, &RecentMenu::chosen, this, &MainWindow::openWith);
    connect(panel_, &ViewPanel::filesDropped, this, &MainWindow::open);
    connect(menus_.savePicture, &QAction::triggered, this, [this] { savePicture(askForPicture(this)); });
    connect(menus_.exportStudy, &QAction::triggered, this, [this] {
        const bool something = workbench_.shown() != Workbench::Shown::nothing &&
                               workbench_.shown() != Workbench::Shown::savedResult;
        const QString folder =
            something ? askForFolder(this, tr("%1 to folder").arg(exportWords())) : QStringLiteral(".");
        if (folder.isEmpty()) return;
        if (mayReplace(this, folder, workbench_.filesInTheWay(folder.toStdString())))
            workbench_.exportShown(folder.toStdString(), panel_->legend().changeScale());
    });
    connect(menus_.quit, &QAction::triggered, this, &QWidget::close);
}

void MainWindow::connectOptions() {
    connect(menus_.openWith, &QAction::triggered, this, [this] {
        if (const QStringList files = askForCity(this); !files.isEmpty()) options_->ask(files, {});
    });
    connect(options_, &OpenOptions::chosen, this, &MainWindow::openWith);
    connect(&workbench_, &Workbench::openFailed, this, &MainWindow::showOpenFailure);
}

void MainWindow::connectStudyMenu() {
    connect(docks_.study, &StudyDock::runRequested, &workbench_, &Workbench::run);
    connect(menus_.run, &QAction::triggered, &workbench_, &Workbench::run);
    connect(menus_.cancel, &QAction::triggered, &workbench_.running(), &JobSlot::cancel);
    connect(menus_.gross, &QAction::triggered, this,
            [this] { panel_->legend().setMeasure(ShadowMeasure::gross); });
    connect(menus_.continuous, &QAction::triggered, this,
            [this] { panel_->legend().setMeasure(ShadowMeasure::continuous); });
    QUndoStack& undo = workbench_.document().undoStack();
    QAction* undoAction = undo.createUndoAction(this);
    undoAction->setShortcut(QKeySequence::Undo);
    QAction* redoAction = undo.createRedoAction(this);
    redoAction->setShortcut(QKeySequence::Redo);
    menus_.edit->addActions({undoAction, redoAction});
}

// Goes to the building that a warning refers to.
void MainWindow::goToPlace(const QString& where) {
    if (!workbench_.city()) return;
    const City& city = workbench_.city()->city();
    const auto building = buildingNamed(city, where.toStdString());
    if (!building)
        return panel_->messages().showNote(tr("%1 is not a building of the displayed city").arg(where));
    Box2 box = bounds(*city.buildings[*building]);
    const glm::vec2 border = glm::max((box.high - box.low) * 1.5F, glm::vec2(40.0F));
    box = {box.low - border, box.high + border};
    panel_->navigator().showSlanting(box);
    tools_.building().select(building);
}

void MainWindow::connectViewMenu() {
    ViewNavigator& navigator = panel_->navigator();
    connect(menus_.wholeCity, &QAction::triggered, &navigator, &ViewNavigator::showWholeCity);
    connect(menus_.northUp, &QAction::triggered, &navigator, &ViewNavigator::turnNorthUp);
    connect(menus_.fromAbove, &QAction::triggered, &navigator, &ViewNavigator::lookFromAbove);
    connect(menus_.region, &QAction::triggered, this, [this] {
        const Box2 box = bounds(workbench_.document().settings().region);
        if (!box.empty()) panel_->navigator().show(box);
    });
    connect(menus_.faces, &QAction::toggled, &panel_->view(), &CityView::showFaces);
    connect(menus_.keys, &QAction::triggered, this, [this] { panel_->messages().showHelp(mouseAndKeys()); });
}

void MainWindow::connectRegion() {
    PolygonTool& tool = panel_->regionTool();
    connect(docks_.study, &StudyDock::drawRequested, this, &MainWindow::draw);
    connect(menus_.drawRegion, &QAction::triggered, this, [this] { draw(true); });
    connect(&tool, &PolygonTool::activeChanged, docks_.study, &StudyDock::setDrawing);
    connect(&tool, &PolygonTool::finished, this, &MainWindow::takeDrawnRegion);
    connect(docks_.study, &StudyDock::viewRegionRequested, this,
            [this] { changeRegion(panel_->visibleGround()); });
    connect(docks_.study, &StudyDock::wholeCityRequested, this, &MainWindow::takeWholeCity);
    connect(menus_.regionFile, &QAction::triggered, this, &MainWindow::readRegionFile);
}

void MainWindow::connectModes() {
    connect(&mode_, &ModeSwitch::changed, this, [this](ViewMode mode) {
        panel_->results().setMode(mode);
        exploration_.setActive(mode == ViewMode::exploration);
    });
    connect(menus_.byMaps, &QAction::toggled, &exploration_, &Exploration::setByMaps);
    connect(&exploration_, &Exploration::changed, this,
            [this] { panel_->results().setExplored(exploration_.answer()); });
    connect(&exploration_, &Exploration::failed, &panel_->messages(), &MessageBar::showError);
    connect(&panel_->view(), &CityView::poseChanged, this, [this] {
        ViewLens lens = panel_->view().lens();
        lens.widthPx *= panel_->view().devicePixelRatio();
        lens.heightPx *= panel_->view().devicePixelRatio();
        exploration_.look(panel_->view().pose(), lens);
    });
    panel_->results().setMode(mode_.mode());
    exploration_.setActive(mode_.mode() == ViewMode::exploration);
}

}  // namespace noonmark
