#include "app/window/frame/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QLabel>
#include <QMenu>
#include <QScreen>
#include <QStandardPaths>
#include <QStatusBar>
#include <QToolBar>
#include <QUndoStack>

#include "app/report/sheets/period_words.h"
#include "app/window/project/project_dock.h"
#include "app/window/project/scenario_bar.h"
#include "app/window/project/scenario_table.h"
#include "app/window/project/scenarios_dock.h"
#include "app/window/project/weights_dock.h"
#include "app/window/study/open_options.h"
#include "app/window/study/results_dock.h"
#include "app/window/study/study_dock.h"
#include "app/window/study/warnings_dock.h"
#include "app/window/view/view_panel.h"
#include "app/window/widgets/file_dialogs.h"
#include "app/window/widgets/progress_strip.h"
#include "core/io/footprints/place_advice.h"
#include "core/io/read_region.h"

namespace noonmark {

namespace {

constexpr int layoutVersion = 4;
constexpr int frameWidth = 10;  // upper bound for the window frame on common desktops
constexpr int frameHeight = 40;

QString unsavedFolder(const QSettings& settings) {
    const QString usual = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return settings.value(QStringLiteral("unsavedFolder"), usual).toString();
}

}  // namespace

MainWindow::MainWindow(QSettings& settings)
    : settings_(settings),
      menus_(*this),
      recent_(*menus_.recent, settings),
      panel_(new ViewPanel),
      tools_(*panel_, horizons_),
      docks_{new ProjectDock(workbench_.session()),
             new StudyDock(workbench_.document()),
             new ResultsDock,
             new ScenariosDock(workbench_.session()),
             new WeightsDock(workbench_.session()),
             new WarningsDock,
             tools_.dock(),
             tools_.massingDock()},
      progress_(new ProgressStrip(QBoxLayout::LeftToRight)),
      hover_(new QLabel),
      options_(new OpenOptions(this)),
      mode_(workbench_.document()),
      place_(unsavedFolder(settings)),
      saving_(
          workbench_.session(), [this] { return viewNow(); }, place_.file()),
      askUnsaved_([this] { return askUnsaved(); }),
      askSaveAs_([this](const QString& suggested) { return askForProject(this, suggested); }) {
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
    connectResults();
    connectProject();
    connectEditing();
    connectTime();
    restoreGeometry(settings_.value(QStringLiteral("geometry")).toByteArray());
    restoreState(settings_.value(QStringLiteral("docks")).toByteArray(), layoutVersion);
    fitScreen();
}

MainWindow::~MainWindow() = default;

// Limits the window to the available screen at any scale factor, and leaves room for the window frame.
void MainWindow::fitScreen() {
    const QSize room = screen()->availableGeometry().size() - QSize(frameWidth, frameHeight);
    if (!isMaximized() && !isFullScreen()) resize(size().boundedTo(room));
}

void MainWindow::makeStatusBar() {
    hover_->setObjectName(QStringLiteral("hover"));
    statusBar()->addWidget(hover_, 1);
    statusBar()->addPermanentWidget(progress_);
    // A fixed height: the view must not move under the cursor when the progress bar appears.
    statusBar()->setMinimumHeight(progress_->sizeHint().height() + 4);
    connect(panel_, &ViewPanel::hovered, hover_, &QLabel::setText);
    // Hidden explicitly while a status tip is shown: QStatusBar hides only widgets that are already visible
    // when the tip arrives.
    connect(statusBar(), &QStatusBar::messageChanged, hover_,
            [this](const QString& tip) { hover_->setVisible(tip.isEmpty()); });
}

void MainWindow::makeModeBar() {
    QToolBar* bar = addToolBar(tr("Mode"));
    bar->setObjectName(QStringLiteral("modeBar"));
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    bar->addActions(mode_.actions());
    menus_.modes->addActions(mode_.actions());
    bar->addWidget(new ScenarioBar(workbench_.session()));
}

void MainWindow::draw(bool on) {
    PolygonTool& tool = panel_->regionTool();
    if (on && workbench_.city())
        tool.begin();
    else
        tool.cancel();
    docks_.study->setDrawing(tool.active());
    panel_->view().requestActivate();  // the view receives the keys that finish or cancel the polygon
}

void MainWindow::changeRegion(const Region& region) {
    if (region.polygons.empty())
        return panel_->messages().showError(
            {"No ground of the city is visible", {}, "Move the view to the city first"});
    StudySettings settings = workbench_.document().settings();
    settings.region = region;
    workbench_.document().change(settings, tr("region"));
}

// A drawn region is user work, so it is added to the project under its own name, in one undo step together
// with the change of the study.
void MainWindow::takeDrawnRegion(const std::vector<Footprint>& pieces) {
    Project next = workbench_.session().project();
    const Region region{freeName(next, ProjectPart::region, "Region"), pieces};
    next.regions.push_back(region);
    const QString what = tr("draw %1").arg(QString::fromStdString(region.name));
    QUndoStack& undo = workbench_.document().undoStack();
    undo.beginMacro(what);
    if (workbench_.session().change(std::move(next), what)) changeRegion(region);
    undo.endMacro();
}

void MainWindow::takeWholeCity() {
    if (!workbench_.city()) return;
    Region all = makeRegionFromLocalBox(panel_->view().viewBounds().box);
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
    whenSafe([this, files, reading] {
        panel_->messages().hide();  // its buttons refer to the previous files
        opening_ = files;
        reading_ = reading;
        workbench_.open(files, reading);
    });
}

// If the user stated a CRS or an anchor that does not fit, the same options dialog is offered to correct it.
void MainWindow::showOpenFailure(const Error& error) {
    saving_.keepUnsaved();  // the work discarded for the new file is still open
    if (isCancelled(error)) return;
    panel_->messages().showError(error);
    if (asksForPlace(error) || reading_.crs || reading_.meshAnchor)
        panel_->messages().offer(tr("Open with options..."), [this] { options_->ask(opening_, reading_); });
}

// The camera stays: the city may be another scenario of the same project.
void MainWindow::showCity() {
    const CameraPose pose = panel_->view().pose();
    panel_->showCity(workbench_.city());
    panel_->view().setPose(pose);
    tools_.setCity(workbench_.city());
    exploration_.setCity(workbench_.city());
    docks_.study->setTerrain(workbench_.city()->city().terrain != nullptr);
    docks_.warnings->show(workbench_.city()->loaded.read.warnings);
    docks_.results->show({});
    showAnswer();
    offerTime();
    showDocument();
    answerAnew();
}

void MainWindow::showDocument() {
    const StudySettings& settings = workbench_.document().settings();
    panel_->showRegion(settings.region);
    if (workbench_.city())
        exploration_.setPeriod(settings.period, makeObserver(workbench_.city()->city(), settings));
    askLive();
    showOutdated();
    showExport();
    docks_.scenarios->table().setStudies(workbench_.studies(), settings);
}

void MainWindow::savePicture(const QString& file) {
    if (file.isEmpty()) return;
    if (const auto may = checkOutput(file.toStdString(), OutputKind::picture, workbench_.exportRules()); !may)
        return panel_->messages().showError(may.error());
    const ProjectSession& session = workbench_.session();
    QString title = tr("%1: %2").arg(projectName(), QString::fromStdString(session.scenario()));
    if (!session.baseline().empty())
        title = tr("%1 compared with %2").arg(title, QString::fromStdString(session.baseline()));
    const Period& period = mode_.mode() == ViewMode::exploration || !answerShown_
                               ? workbench_.document().settings().period
                               : answered_.period;
    panel_->takePicture(title, describePeriod(period), [this, file](const QImage& image) {
        if (image.save(file)) return panel_->messages().showNote(tr("Picture saved as %1").arg(file));
        panel_->messages().showError(
            {"The picture could not be written", file.toStdString(), "Choose another folder"});
    });
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!maySafely([this] { close(); })) return event->ignore();
    settings_.setValue(QStringLiteral("geometry"), saveGeometry());
    settings_.setValue(QStringLiteral("docks"), saveState(layoutVersion));
    QMainWindow::closeEvent(event);
}

}  // namespace noonmark
