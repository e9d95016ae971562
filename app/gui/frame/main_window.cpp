#include "app/gui/frame/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QScreen>
#include <QStandardPaths>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <utility>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/looks/application_theme.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/docks/contributions/contributions_dock.h"
#include "app/gui/docks/elements/elements_dock.h"
#include "app/gui/docks/places/places_dock.h"
#include "app/gui/docks/point/point_dock.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/docks/review/place_list.h"
#include "app/gui/docks/review/review_dock.h"
#include "app/gui/docks/review/review_form.h"
#include "app/gui/docks/scenarios/scenario_bar.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/docks/scenarios/scenarios_dock.h"
#include "app/gui/docks/study_form/accuracy_section.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/docks/weights/weights_dock.h"
#include "app/gui/docks/weights/weights_model.h"
#include "app/gui/frame/window_layout.h"
#include "app/gui/frame/window_menus.h"
#include "app/gui/view/panel/view_panel.h"
#include "render/view/traced_city.h"
#include "scenarios/scenario.h"

namespace noonmark {

namespace {

constexpr int frameWidth = 10;  // upper bound for the window frame on common desktops
constexpr int frameHeight = 40;
constexpr int hintMs = 10000;

QString unsavedFolder(const QSettings& settings) {
    const QString standard = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return settings.value(QStringLiteral("unsavedFolder"), standard).toString();
}

}  // namespace

MainWindow::MainWindow(QSettings& settings, std::shared_ptr<Workbench> workbench)
    : settings_(settings),
      shared_(std::move(workbench)),
      workbench_(*shared_),
      review_(workbench_),
      glazingReview_(workbench_, review_),
      panel_(new ViewPanel),
      tools_(*panel_, horizons_),
      points_(workbench_, *panel_),
      docks_{new ProjectDock(workbench_.session()),
             new StudyDock(workbench_.document()),
             new ResultsDock,
             new ScenariosDock(workbench_.session(), settings),
             new WeightsDock(workbench_.session()),
             new WarningsDock,
             new ReviewForm(review_, glazingReview_, workbench_.session()),
             new ReviewDock(review_, glazingReview_, workbench_.session()),
             new PointDock(points_),
             new ElementsDock,
             new ContributionsDock,
             new PlacesDock,
             tools_.dock(),
             tools_.massingDock(),
             tools_.treeDock()},
      progress_(new ProgressStrip(QBoxLayout::LeftToRight)),
      hover_(new QLabel),
      mode_(),
      view_(workbench_, *panel_, mode_, review_, settings),
      store_(unsavedFolder(settings)),
      saving_(
          workbench_, store_, [this] { return projectToSave(); }, panel_->messages(), *this),
      opening_(workbench_, saving_, settings, panel_->messages(), *this),
      recovery_(workbench_, store_, saving_, panel_->messages()),
      links_(*docks_.elements, *panel_),
      verdicts_(docks_.review->glazingPanel(), glazingReview_, review_, workbench_, *panel_),
      picking_(workbench_, *panel_),
      contributions_(*docks_.contributions, workbench_, tools_, *panel_),
      display_(workbench_, mode_, tools_.context().preview,
               {panel_->results(), *docks_.results, *docks_.elements, *docks_.warnings,
                docks_.scenarios->table(), panel_->legend()}),
      placeLinks_(workbench_, display_, *docks_.places, *panel_),
      results_(workbench_, mode_, display_, *panel_, *docks_.project, *this),
      copying_(results_, *docks_.results, *panel_),
      movies_(workbench_, *panel_, time_, *this),
      study_(workbench_, mode_, display_, *panel_),
      region_(workbench_, *panel_, *docks_.study, *docks_.project, *this),
      places_(workbench_, opening_, tools_, *panel_, *docks_.project, *this),
      photograph_(workbench_, panel_->messages(), *this),
      trees_(workbench_, panel_->messages(), *this),
      reviews_(review_, glazingReview_, {*docks_.reviewForm, *docks_.review}, tools_.context().preview,
               places_, *panel_),
      answers_({workbench_, review_, glazingReview_, docks_.weights->model()}, docks_.scenarios->table()),
      scenarios_(workbench_, answers_, *docks_.project, *docks_.scenarios),
      edits_(workbench_, tools_, mode_, *panel_),
      towers_(settings_, tools_),
      camera_(workbench_, *panel_, exploration_, *docks_.project),
      search_(workbench_, tools_, *panel_),
      help_(opening_, settings_, *this, *panel_),
      time_(workbench_, mode_, *panel_, horizons_),
      dome_(settings_, workbench_, *panel_, time_, points_),
      presets_(*panel_, time_),
      comparing_(workbench_, *panel_, time_),
      preferences_(settings_, *this),
      tours_(opening_, {*this, workbench_, review_, *panel_}),
      savedViews_(workbench_.session(), *panel_, *docks_.project, *this),
      context_(workbench_, tools_, region_, places_, points_, *panel_) {
    setWindowTitle(QStringLiteral("Noonmark"));
    resize(1360, 860);
    setCentralWidget(panel_);
    fillMenus(placeDocks(*this, docks_) + makeSideSwitches(*this));
    makeStatusBar();
    connectJobs();
    connectScenarioJobs();
    connectWorkbench();
    connectDocks();
    connectModes();
    connectPreferences();
    nameForScreenReaders(*this);
    restoreGeometry(settings_.value(QStringLiteral("geometry")).toByteArray());
    restoreState(settings_.value(QStringLiteral("docks")).toByteArray(), layoutVersion);
    hideAnswerPanels();
    fitScreen();
}

MainWindow::~MainWindow() = default;

// Limits the window to the available screen at any scale factor, and leaves room for the window frame.
void MainWindow::fitScreen() {
    layout()->activate();  // without the panels that were hidden since
    const QSize room = screen()->availableGeometry().size() - QSize(frameWidth, frameHeight);
    if (!isMaximized() && !isFullScreen()) resize(size().boundedTo(room));
}

void MainWindow::fillMenus(const QList<QAction*>& docks) {
    const WindowActions actions{opening_,
                                saving_,
                                results_,
                                movies_,
                                copying_,
                                edits_,
                                scenarios_,
                                study_,
                                region_,
                                places_,
                                photograph_,
                                reviews_,
                                camera_,
                                presets_,
                                savedViews_,
                                search_,
                                preferences_,
                                help_,
                                tours_,
                                towers_,
                                new ThemeMenu(settings_, this),
                                comparing_.actions(),
                                mode_.actions(),
                                docks,
                                time_.actions(),
                                dome_.action()};
    QAction* quit = noonmark::fillMenus(*menuBar(), actions);
    makeToolBars(actions);
    menuBar()->setCornerWidget(search_.field());
    search_.findCommandsOf(*menuBar());
    connect(quit, &QAction::triggered, this, &QWidget::close);
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
    // In the status bar, since the message bar would move the view under the cursor.
    connect(&tools_, &EditTools::hinted, this,
            [this](const QString& text) { statusBar()->showMessage(text, hintMs); });
}

void MainWindow::makeToolBars(const WindowActions& actions) {
    // First, so that a narrow window shows it whole and moves tools into the menu at the end.
    QToolBar* bar = addToolBar(tr("Mode"));
    bar->setObjectName(QStringLiteral("modeBar"));
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->addActions(mode_.actions());
    bar->addAction(help_.questions());
    if (auto* ask = qobject_cast<QToolButton*>(bar->widgetForAction(help_.questions())))
        ask->setPopupMode(QToolButton::InstantPopup);
    paper_ = bar->addAction(tr("As in the paper"));
    paper_->setCheckable(true);
    paper_->setObjectName(QStringLiteral("paperMaps"));
    paper_->setToolTip(
        tr("Now by shadow accrual maps, studies by inverse accrual maps through the direction "
           "graph.\nApproximate: the legend states the measured error. Verdicts of reviews stay exact"));
    connect(paper_, &QAction::triggered, this, &MainWindow::useMapsOfPaper);
    connect(camera_.exploreByMaps(), &QAction::toggled, this, &MainWindow::showPaper);
    showPaper();
    bar->addWidget(new ScenarioBar(workbench_.session()));
    QToolBar* below = new QToolBar(tr("Time and legend"));
    below->setObjectName(QStringLiteral("timeBar"));
    below->setMovable(false);
    below->addWidget(panel_->takeStrips());
    addToolBar(Qt::BottomToolBarArea, below);
    QToolBar* tools = addToolBar(tr("Tools"));
    tools->setObjectName(QStringLiteral("toolBar"));
    fillToolBar(*tools, actions);
}

// The panels that a kind of study needs, or the baseline of a comparison.
void MainWindow::chooseKind(StudyKind kind) {
    ProjectSession& session = workbench_.session();
    if (kind == StudyKind::review) return showReview();
    if (kind == StudyKind::score) return showDock(docks_.weights);
    if (kind == StudyKind::places) return;  // the form asks for all of it
    if (kind == StudyKind::shadow) return session.compareWith({});
    if (session.scenario() != existingCity) return session.compareWith(existingCity);
    panel_->messages().showNote(tr(
        "Choose a scenario at the top first. A change to a building begins one: click a building, and drag "
        "its arrow or replace it by a tower (Ctrl+T)."));
}

void MainWindow::showModes() {
    panel_->results().setMode(mode_.mode());
    activateExploration();
    showVerdicts();
    if (mode_.mode() == ViewMode::review) showReview();
}

// The question at the left, its answer below.
void MainWindow::showReview() {
    showDock(docks_.review);
    showDock(docks_.reviewForm);
}

// Painted only where they are shown.
void MainWindow::showVerdicts() {
    const bool isReview = mode_.mode() == ViewMode::review;
    panel_->results().setVerdicts(isReview ? makePlaceVerdicts(review_.shown()) : nullptr);
}

// The engines of the paper, for what is explored and for what is studied.
void MainWindow::useMapsOfPaper(bool used) {
    camera_.exploreByMaps()->setChecked(used || !drawsInSoftware());
    const StudySettings& now = workbench_.document().settings();
    const bool terrain = workbench_.city() && workbench_.city()->city().terrain;
    workbench_.document().change(used ? asInPaper(now) : withAccuracy(AccuracyChoice::quick, now, terrain),
                                 used ? tr("as in the paper") : tr("not as in the paper"));
    showPaper();
}

void MainWindow::showPaper() {
    if (paper_ == nullptr) return;
    paper_->setChecked(camera_.exploreByMaps()->isChecked() && isAsInPaper(workbench_.document().settings()));
}

void MainWindow::explore() {
    ViewLens lens = panel_->view().lens();
    lens.widthPx *= panel_->view().devicePixelRatio();
    lens.heightPx *= panel_->view().devicePixelRatio();
    exploration_.look(panel_->view().pose(), lens, panel_->view().section());
}

// A moment has its own shadows, which cost nothing while the camera moves.
void MainWindow::activateExploration() {
    // Of what is being shaped the view shows the change on the ground.
    exploration_.setActive(mode_.mode() == ViewMode::exploration && !time_.showsMoment() &&
                           !tools_.context().preview.shown());
}

// The panel of a card of the start page, with its question chosen.
void MainWindow::answerCard(StartQuestion question) {
    StudyDock& form = *docks_.study;
    showDock(docks_.study);
    if (question == StartQuestion::tower) return showDock(tools_.massingDock());
    if (question == StartQuestion::places) return form.choose(StudyKind::places);
    if (question == StartQuestion::review) return form.choose(StudyKind::review);
    if (question == StartQuestion::score) {
        form.choose(StudyKind::score);
        return showDock(docks_.weights);
    }
    form.choose(StudyKind::shadow);
    workbench_.document().change(workbench_.document().settings(), ElementSettings(), tr("receivers"));
}

// Some time after it was opened, when the first picture is complete.
void MainWindow::storePicture() {
    const QString entry = opening_.recentEntry();
    if (!workbench_.city() || entry.isEmpty() || !panel_->view().isExposed()) return;
    QPointer<MainWindow> alive = this;
    panel_->view().capture([alive, entry](const QImage& image) {
        if (alive) alive->opening_.storePicture(entry, image);
    });
}

// Raises the dock among its tabs. A dock that the user closed stays closed.
void MainWindow::raiseDock(const QWidget* content) {
    for (QDockWidget* dock : findChildren<QDockWidget*>())
        if (dock->isAncestorOf(content)) dock->raise();
}

// Also a dock that the user closed.
void MainWindow::showDock(const QWidget* content) {
    for (QDockWidget* dock : findChildren<QDockWidget*>())
        if (dock->isAncestorOf(content)) openDock(*this, *dock);
}

// What the user reads beside the view, such as contributions, stays in front.
void MainWindow::showAnswerPanel() {
    for (QDockWidget* dock : findChildren<QDockWidget*>())
        if (dock->isAncestorOf(docks_.results)) openDock(*this, *dock, DockPlace::behindOthers);
}

// Until there is an answer the view has their room.
void MainWindow::hideAnswerPanels() {
    if (workbench_.answer() || workbench_.past()) return;
    for (QDockWidget* dock : findChildren<QDockWidget*>())
        if (dock->isAncestorOf(docks_.results) || dock->isAncestorOf(docks_.places)) dock->hide();
}

void MainWindow::savePoint() {
    const QString file = askForSky(this);
    const auto saved = docks_.point->save(file, workbench_.exportRules());
    if (!saved) return panel_->messages().showError(saved.error());
    if (!file.isEmpty()) panel_->messages().showNote(tr("Saved as %1").arg(file));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!saving_.confirmUnsaved([this] { close(); })) return event->ignore();
    help_.closeStart();
    settings_.setValue(QStringLiteral("geometry"), saveGeometry());
    settings_.setValue(QStringLiteral("docks"), saveState(layoutVersion));
    QMainWindow::closeEvent(event);
}

}  // namespace noonmark
