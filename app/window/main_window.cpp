#include "app/window/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QStatusBar>

#include "app/window/progress_strip.h"
#include "app/window/results_dock.h"
#include "app/window/study_dock.h"
#include "app/window/view_panel.h"
#include "app/window/warnings_dock.h"

namespace noonmark {

namespace {

constexpr int layoutVersion = 1;
const QString keyHelp = QStringLiteral(
    "Left or middle drag turns, right drag (or Shift) moves, the wheel zooms to the cursor.  Arrow keys "
    "move, + and - "
    "zoom.  Home: whole city.  N: north up.  T: from above.  R: region.  B: buildings as lines.  Ctrl+R: "
    "run.");

QString filters() {
    return QObject::tr(
        "Cities and terrain (*.geojson *.json *.gpkg *.shp *.osm *.pbf *.jsonl *.city.json *.obj *.ply "
        "*.gltf *.glb "
        "*.tif *.tiff *.asc *.vrt);;All files (*)");
}

// What the view opens with: the region and some of its neighbourhood.
Box2 startView(const Region& region) {
    const Box2 box = bounds(region);
    const glm::vec2 border = (box.high - box.low) * 0.15F;
    return {box.low - border, box.high + border};
}

// Docks may be lower than what they hold.
QScrollArea* scrolled(QWidget* content, int leastWidth) {
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(leastWidth);
    return scroll;
}

}  // namespace

MainWindow::MainWindow(QSettings& settings)
    : settings_(settings),
      recent_(settings),
      menus_(*this),
      panel_(new ViewPanel),
      study_(new StudyDock(workbench_.document())),
      results_(new ResultsDock),
      warnings_(new WarningsDock),
      progress_(new ProgressStrip(QBoxLayout::LeftToRight)),
      hover_(new QLabel) {
    setWindowTitle(QStringLiteral("Noonmark"));
    resize(1360, 860);
    setCentralWidget(panel_);
    makeDocks();
    makeStatusBar();
    connectWorkbench();
    connectMenus();
    connectViewMenu();
    connectStudyDock();
    fillRecent();
    restoreLayout();
}

MainWindow::~MainWindow() = default;

void MainWindow::addDock(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title);
    dock->setObjectName(QString::fromLatin1(name));  // the saved layout knows docks by name
    dock->setWidget(content);
    addDockWidget(area, dock);
    menus_.docks->addAction(dock->toggleViewAction());
}

void MainWindow::makeDocks() {
    addDock(tr("Study"), "studyDock", scrolled(study_, study_->minimumSizeHint().width() + 22),
            Qt::LeftDockWidgetArea);
    addDock(tr("Results"), "resultsDock", scrolled(results_, 270), Qt::RightDockWidgetArea);
    addDock(tr("Warnings"), "warningsDock", warnings_, Qt::RightDockWidgetArea);
    const auto docks = findChildren<QDockWidget*>();
    resizeDocks({docks[1], docks[2]}, {420, 300}, Qt::Vertical);
}

void MainWindow::makeStatusBar() {
    statusBar()->addWidget(hover_, 1);
    statusBar()->addPermanentWidget(progress_);
    connect(panel_, &ViewPanel::hovered, hover_, &QLabel::setText);
}

void MainWindow::connectWorkbench() {
    const auto strip = [this](JobSlot& slot, ProgressStrip& bar) {
        connect(&slot, &JobSlot::started, &bar, &ProgressStrip::follow);
        connect(&slot, &JobSlot::ended, &bar, &ProgressStrip::finish);
        connect(&bar, &ProgressStrip::cancelRequested, &slot, &JobSlot::cancel);
    };
    strip(workbench_.opening(), *progress_);
    strip(workbench_.writing(), *progress_);
    strip(workbench_.running(), study_->progress());
    connect(&workbench_.running(), &JobSlot::started, study_, [this] { study_->setRunning(true); });
    connect(&workbench_.running(), &JobSlot::ended, study_, [this] { study_->setRunning(false); });
    connect(&workbench_, &Workbench::cityOpened, this, &MainWindow::showCity);
    connect(&workbench_, &Workbench::studyDone, this, &MainWindow::showStudy);
    connect(&workbench_, &Workbench::failed, &panel_->messages(), &MessageBar::showError);
    connect(&workbench_, &Workbench::noted, &panel_->messages(), &MessageBar::showNote);
    connect(&workbench_.document(), &StudyDocument::changed, this, &MainWindow::showDocument);
}

void MainWindow::connectMenus() {
    connect(menus_.open, &QAction::triggered, this, &MainWindow::askToOpen);
    connect(menus_.openPark, &QAction::triggered, this,
            [this] { open({QStringLiteral("sample:central-park-south")}); });
    connect(menus_.openGrid, &QAction::triggered, this, [this] { open({QStringLiteral("sample:grid")}); });
    connect(menus_.savePicture, &QAction::triggered, this, &MainWindow::askToSavePicture);
    connect(menus_.exportStudy, &QAction::triggered, this, &MainWindow::askToExport);
    connect(menus_.quit, &QAction::triggered, this, &QWidget::close);
    connect(menus_.run, &QAction::triggered, &workbench_, &Workbench::run);
    connect(menus_.cancel, &QAction::triggered, &workbench_.running(), &JobSlot::cancel);
    connect(menus_.gross, &QAction::triggered, this,
            [this] { panel_->legend().setMeasure(ShadowMeasure::gross); });
    connect(menus_.continuous, &QAction::triggered, this,
            [this] { panel_->legend().setMeasure(ShadowMeasure::continuous); });
    connect(panel_, &ViewPanel::filesDropped, this, &MainWindow::open);
    QUndoStack& undo = workbench_.document().undoStack();
    QAction* undoAction = undo.createUndoAction(this);
    undoAction->setShortcut(QKeySequence::Undo);
    QAction* redoAction = undo.createRedoAction(this);
    redoAction->setShortcut(QKeySequence::Redo);
    menus_.edit->addActions({undoAction, redoAction});
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
    connect(menus_.keys, &QAction::triggered, this, [this] { panel_->messages().showNote(keyHelp); });
}

void MainWindow::connectStudyDock() {
    RegionTool& tool = panel_->regionTool();
    const auto draw = [this, &tool](bool on) {
        if (on && workbench_.city())
            tool.begin();
        else
            tool.cancel();
        study_->setDrawing(tool.active());
        panel_->view().requestActivate();
    };
    connect(study_, &StudyDock::runRequested, &workbench_, &Workbench::run);
    connect(study_, &StudyDock::drawRequested, this, draw);
    connect(menus_.drawRegion, &QAction::triggered, this, [draw] { draw(true); });
    connect(&tool, &RegionTool::activeChanged, study_, &StudyDock::setDrawing);
    connect(&tool, &RegionTool::finished, this, &MainWindow::changeRegion);
    connect(study_, &StudyDock::viewRegionRequested, this, [this] { changeRegion(panel_->visibleGround()); });
    connect(study_, &StudyDock::wholeCityRequested, this, [this] {
        if (!workbench_.city()) return;
        Region all = regionFromLocalBox(panel_->view().viewBounds().box);
        all.name = "the whole city";
        changeRegion(all);
    });
}

void MainWindow::changeRegion(const Region& region) {
    if (region.polygons.empty())
        return panel_->messages().showError(
            {"The view shows no ground of the city", {}, "Turn the view to the city first"});
    StudySettings settings = workbench_.document().settings();
    settings.region = region;
    workbench_.document().change(settings, tr("region"));
}

void MainWindow::open(const QStringList& files) {
    opening_ = files;
    workbench_.open(files);
}

void MainWindow::showCity() {
    panel_->messages().hide();
    panel_->showCity(workbench_.city());
    results_->show(nullptr);
    warnings_->show(workbench_.city()->loaded.read.warnings);
    setWindowTitle(tr("%1 - Noonmark").arg(RecentFiles::nameOf(opening_.join(QLatin1Char('\n')))));
    recent_.add(opening_);
    fillRecent();
    showDocument();
    panel_->navigator().showSlanting(startView(workbench_.document().settings().region));
}

void MainWindow::showStudy() {
    const auto study = workbench_.study();
    answered_ = study->settings;
    panel_->messages().hide();
    panel_->showStudy(study);
    results_->show(study.get());
    warnings_->show(study->warnings);
    showDocument();
}

void MainWindow::showDocument() {
    const StudySettings& settings = workbench_.document().settings();
    panel_->showRegion(settings.region);
    if (workbench_.study()) results_->setOutdated(settings != answered_);
}

void MainWindow::fillRecent() {
    menus_.recent->clear();
    for (const QString& entry : recent_.entries()) {
        QAction* action = menus_.recent->addAction(RecentFiles::nameOf(entry));
        action->setStatusTip(entry);
        connect(action, &QAction::triggered, this, [this, entry] { open(RecentFiles::filesOf(entry)); });
    }
    menus_.recent->setEnabled(!menus_.recent->isEmpty());
}

void MainWindow::askToOpen() { open(QFileDialog::getOpenFileNames(this, tr("Open a city"), {}, filters())); }

void MainWindow::askToSavePicture() {
    const QString file = QFileDialog::getSaveFileName(this, tr("Save picture"),
                                                      QStringLiteral("noonmark.png"), tr("Pictures (*.png)"));
    if (!file.isEmpty()) savePicture(file.contains(QLatin1Char('.')) ? file : file + QStringLiteral(".png"));
}

void MainWindow::savePicture(const QString& file) {
    panel_->takePicture([this, file](const QImage& image) {
        if (image.save(file)) return panel_->messages().showNote(tr("Picture saved as %1").arg(file));
        panel_->messages().showError(
            {"The picture cannot be written", file.toStdString(), "Choose another folder"});
    });
}

void MainWindow::askToExport() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Export study into a folder"));
    if (!folder.isEmpty()) workbench_.exportStudy(folder.toStdString());
}

void MainWindow::restoreLayout() {
    restoreGeometry(settings_.value(QStringLiteral("geometry")).toByteArray());
    restoreState(settings_.value(QStringLiteral("docks")).toByteArray(), layoutVersion);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    settings_.setValue(QStringLiteral("geometry"), saveGeometry());
    settings_.setValue(QStringLiteral("docks"), saveState(layoutVersion));
    QMainWindow::closeEvent(event);
}

}  // namespace noonmark
