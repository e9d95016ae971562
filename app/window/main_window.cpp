#include "app/window/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QLabel>
#include <QMenu>
#include <QStatusBar>

#include "app/window/file_dialogs.h"
#include "app/window/open_options.h"
#include "app/window/progress_strip.h"
#include "app/window/results_dock.h"
#include "app/window/study_dock.h"
#include "app/window/view_panel.h"
#include "app/window/warnings_dock.h"
#include "core/io/place_advice.h"
#include "core/io/read_region.h"

namespace noonmark {

namespace {

constexpr int layoutVersion = 1;

// What the view opens with: the region and some of its neighbourhood.
Box2 startView(const Region& region) {
    const Box2 box = bounds(region);
    const glm::vec2 border = (box.high - box.low) * 0.15F;
    return {box.low - border, box.high + border};
}

LonLat middleOf(const City& city) {
    const Box2 box = bounds(city);
    if (box.empty()) return city.frame.origin();
    return city.frame.lonLatFromLocal((glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0);
}

}  // namespace

MainWindow::MainWindow(QSettings& settings)
    : settings_(settings),
      menus_(*this),
      recent_(*menus_.recent, settings),
      panel_(new ViewPanel),
      docks_{new StudyDock(workbench_.document()), new ResultsDock, new WarningsDock},
      progress_(new ProgressStrip(QBoxLayout::LeftToRight)),
      hover_(new QLabel),
      options_(new OpenOptions(this)) {
    setWindowTitle(QStringLiteral("Noonmark"));
    resize(1360, 860);
    setCentralWidget(panel_);
    placeDocks(*this, docks_, *menus_.docks);
    makeStatusBar();
    connectJobs();
    connectWorkbench();
    connectFileMenu();
    connectOptions();
    connectStudyMenu();
    connectViewMenu();
    connectRegion();
    restoreGeometry(settings_.value(QStringLiteral("geometry")).toByteArray());
    restoreState(settings_.value(QStringLiteral("docks")).toByteArray(), layoutVersion);
}

MainWindow::~MainWindow() = default;

void MainWindow::makeStatusBar() {
    statusBar()->addWidget(hover_, 1);
    statusBar()->addPermanentWidget(progress_);
    connect(panel_, &ViewPanel::hovered, hover_, &QLabel::setText);
}

void MainWindow::connectJobs() {
    const auto show = [this](JobSlot& slot, ProgressStrip& bar) {
        connect(&slot, &JobSlot::started, &bar, &ProgressStrip::follow);
        connect(&slot, &JobSlot::ended, &bar, &ProgressStrip::finish);
        connect(&bar, &ProgressStrip::cancelRequested, &slot, &JobSlot::cancel);
    };
    show(workbench_.opening(), *progress_);
    show(workbench_.writing(), *progress_);
    show(workbench_.running(), docks_.study->progress());
    connect(&workbench_.running(), &JobSlot::started, docks_.study,
            [this] { docks_.study->setRunning(true); });
    connect(&workbench_.running(), &JobSlot::ended, docks_.study,
            [this] { docks_.study->setRunning(false); });
}

void MainWindow::connectWorkbench() {
    connect(&workbench_, &Workbench::cityOpened, this, &MainWindow::showCity);
    connect(&workbench_, &Workbench::studyDone, this, &MainWindow::showStudy);
    connect(&workbench_, &Workbench::failed, &panel_->messages(), &MessageBar::showError);
    connect(&workbench_, &Workbench::noted, &panel_->messages(), &MessageBar::showNote);
    connect(&workbench_.document(), &StudyDocument::changed, this, &MainWindow::showDocument);
}

void MainWindow::connectFileMenu() {
    const auto opens = [this](QAction* action, const char* sample) {
        connect(action, &QAction::triggered, this, [this, sample] { open({QString::fromLatin1(sample)}); });
    };
    opens(menus_.openPark, "sample:central-park-south");
    opens(menus_.openGrid, "sample:grid");
    connect(menus_.open, &QAction::triggered, this, [this] { open(askForCity(this)); });
    connect(&recent_, &RecentMenu::chosen, this, &MainWindow::open);
    connect(panel_, &ViewPanel::filesDropped, this, &MainWindow::open);
    connect(menus_.savePicture, &QAction::triggered, this, [this] { savePicture(askForPicture(this)); });
    connect(menus_.exportStudy, &QAction::triggered, this, [this] {
        const QString folder = workbench_.study() ? askForFolder(this) : QStringLiteral(".");
        if (!folder.isEmpty()) workbench_.exportStudy(folder.toStdString());
    });
    connect(menus_.quit, &QAction::triggered, this, &QWidget::close);
}

void MainWindow::connectOptions() {
    connect(menus_.openWith, &QAction::triggered, this, [this] {
        if (const QStringList files = askForCity(this); !files.isEmpty()) options_->ask(files, {});
    });
    connect(options_, &OpenOptions::chosen, this, &MainWindow::openWith);
    connect(&workbench_, &Workbench::openFailed, this, &MainWindow::showOpenFailure);
    connect(&panel_->messages(), &MessageBar::remedyChosen, this,
            [this] { options_->ask(opening_, reading_); });
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
    RegionTool& tool = panel_->regionTool();
    connect(docks_.study, &StudyDock::drawRequested, this, &MainWindow::draw);
    connect(menus_.drawRegion, &QAction::triggered, this, [this] { draw(true); });
    connect(&tool, &RegionTool::activeChanged, docks_.study, &StudyDock::setDrawing);
    connect(&tool, &RegionTool::finished, this, &MainWindow::changeRegion);
    connect(docks_.study, &StudyDock::viewRegionRequested, this,
            [this] { changeRegion(panel_->visibleGround()); });
    connect(docks_.study, &StudyDock::wholeCityRequested, this, &MainWindow::takeWholeCity);
    connect(menus_.regionFile, &QAction::triggered, this, &MainWindow::readRegionFile);
}

void MainWindow::draw(bool on) {
    RegionTool& tool = panel_->regionTool();
    if (on && workbench_.city())
        tool.begin();
    else
        tool.cancel();
    docks_.study->setDrawing(tool.active());
    panel_->view().requestActivate();  // the keys that finish and cancel go there
}

void MainWindow::changeRegion(const Region& region) {
    if (region.polygons.empty())
        return panel_->messages().showError(
            {"The view shows no ground of the city", {}, "Turn the view to the city first"});
    StudySettings settings = workbench_.document().settings();
    settings.region = region;
    workbench_.document().change(settings, tr("region"));
}

void MainWindow::takeWholeCity() {
    if (!workbench_.city()) return;
    Region all = regionFromLocalBox(panel_->view().viewBounds().box);
    all.name = "the whole city";
    changeRegion(all);
}

void MainWindow::readRegionFile() {
    const QString file = workbench_.city() ? askForRegion(this) : QString();
    if (file.isEmpty()) return;
    const auto region = readRegion(file.toStdString(), workbench_.city()->city().frame);
    if (region)
        changeRegion(*region);
    else
        panel_->messages().showError(region.error());
}

void MainWindow::open(const QStringList& files) { openWith(files, {}); }

void MainWindow::openWith(const QStringList& files, const ReadSettings& reading) {
    if (files.isEmpty()) return;
    panel_->messages().hide();  // what it offers is for the files before
    opening_ = files;
    reading_ = reading;
    workbench_.open(files, reading);
}

// A stated place that does not fit is mended where it was stated.
void MainWindow::showOpenFailure(const Error& error) {
    panel_->messages().showError(error);
    if (asksForPlace(error) || reading_.crs || reading_.meshAnchor)
        panel_->messages().offer(tr("Open with options..."));
}

void MainWindow::showCity() {
    panel_->messages().hide();
    panel_->showCity(workbench_.city());
    options_->setMiddle(middleOf(workbench_.city()->city()));
    docks_.results->show(nullptr);
    docks_.warnings->show(workbench_.city()->loaded.read.warnings);
    setWindowTitle(tr("%1 - Noonmark").arg(RecentFiles::nameOf(opening_.join(QLatin1Char('\n')))));
    recent_.add(opening_);
    showDocument();
    panel_->navigator().showSlanting(startView(workbench_.document().settings().region));
}

void MainWindow::showStudy() {
    const auto study = workbench_.study();
    answered_ = study->settings;
    panel_->messages().hide();
    panel_->showStudy(study);
    docks_.results->show(study.get());
    docks_.warnings->show(study->warnings);
    showDocument();
}

void MainWindow::showDocument() {
    const StudySettings& settings = workbench_.document().settings();
    panel_->showRegion(settings.region);
    if (workbench_.study()) docks_.results->setOutdated(settings != answered_);
}

void MainWindow::savePicture(const QString& file) {
    if (file.isEmpty()) return;
    panel_->takePicture([this, file](const QImage& image) {
        if (image.save(file)) return panel_->messages().showNote(tr("Picture saved as %1").arg(file));
        panel_->messages().showError(
            {"The picture cannot be written", file.toStdString(), "Choose another folder"});
    });
}

void MainWindow::closeEvent(QCloseEvent* event) {
    settings_.setValue(QStringLiteral("geometry"), saveGeometry());
    settings_.setValue(QStringLiteral("docks"), saveState(layoutVersion));
    QMainWindow::closeEvent(event);
}

}  // namespace noonmark
