#include "app/window/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QLabel>
#include <QMenu>
#include <QStatusBar>
#include <QToolBar>

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

constexpr int layoutVersion = 2;

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
      options_(new OpenOptions(this)),
      mode_(workbench_.document()) {
    setWindowTitle(QStringLiteral("Noonmark"));
    resize(1360, 860);
    setCentralWidget(panel_);
    placeDocks(*this, docks_, *menus_.docks);
    makeStatusBar();
    makeModeBar();
    connectJobs();
    connectWorkbench();
    connectFileMenu();
    connectOptions();
    connectStudyMenu();
    connectViewMenu();
    connectRegion();
    connectModes();
    restoreGeometry(settings_.value(QStringLiteral("geometry")).toByteArray());
    restoreState(settings_.value(QStringLiteral("docks")).toByteArray(), layoutVersion);
}

MainWindow::~MainWindow() = default;

void MainWindow::makeStatusBar() {
    statusBar()->addWidget(hover_, 1);
    statusBar()->addPermanentWidget(progress_);
    connect(panel_, &ViewPanel::hovered, hover_, &QLabel::setText);
}

void MainWindow::makeModeBar() {
    QToolBar* bar = addToolBar(tr("Mode"));
    bar->setObjectName(QStringLiteral("modeBar"));
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    bar->addActions(mode_.actions());
    menus_.modes->addActions(mode_.actions());
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
    mode_.setAnalysisEngine(StudySettings().engine);
    exploration_.setCity(workbench_.city());
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
    panel_->results().setStudy(study);
    docks_.results->show(study.get());
    docks_.warnings->show(study->warnings);
    showDocument();
}

void MainWindow::showStopped(bool cancelled) {
    panel_->results().setPartial(nullptr);
    if (!cancelled) return;
    panel_->messages().showNote(workbench_.study() ? tr("Cancelled. The study before is shown again.")
                                                   : tr("Cancelled. There is no study yet."));
}

void MainWindow::showDocument() {
    const StudySettings& settings = workbench_.document().settings();
    panel_->showRegion(settings.region);
    if (workbench_.city())
        exploration_.setPeriod(settings.period, observerOf(workbench_.city()->city(), settings));
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
