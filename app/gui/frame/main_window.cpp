#include "app/gui/frame/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QScreen>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
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
#include "app/gui/docks/search/city_search.h"
#include "app/gui/docks/sheets/sheet_form.h"
#include "app/gui/docks/study_form/accuracy_section.h"
#include "app/gui/docks/study_form/element_form.h"
#include "app/gui/docks/study_form/places_form.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/docks/weights/weights_dock.h"
#include "app/gui/docks/weights/weights_model.h"
#include "app/gui/frame/window_layout.h"
#include "app/gui/frame/window_menus.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/time/time_strip.h"
#include "app/input/load_project.h"
#include "render/view/traced_city.h"
#include "scenarios/scenario.h"

namespace noonmark {

namespace {

constexpr const char* chosenWeightsKey = "weights";     // in Project::view: the table of the dock Weights
constexpr const char* kindKey = "question";             // likewise: what the dock Study asks
constexpr const char* placesAskedKey = "places_asked";  // likewise: of which places, and which sun is enough
constexpr const char* placesListedKey = "places_listed";    // likewise: what the table of places lists
constexpr const char* comparedKey = "compared";             // likewise: two scenarios in the view
constexpr const char* clockKey = "clock";                   // likewise: the moment whose sun is shown
constexpr const char* inFrontProperty = "noonmarkInFront";  // of a dock: it is seen among its tabs
constexpr int frameWidth = 10;  // upper bound for the window frame on common desktops
constexpr int frameHeight = 40;
constexpr int hintMs = 10000;
constexpr int cameraRestMs = 150;
constexpr int settledMs = 2500;  // after opening, until the first picture is complete

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

void MainWindow::connectJobs() {
    progress_->follow(workbench_.opening());
    // Not cancellable: the view would show a scenario other than the one selected in the tree.
    progress_->follow(workbench_.following(), ProgressStrip::Jobs::whole);
    for (JobSlot* slot :
         {&comparing_.other().preparing(), &workbench_.reading(), &workbench_.writing(), &saving_.writing(),
          &places_.reading(), &photograph_.reading(), &trees_.reading(), &movies_.writing(),
          &answers_.scoring(), &review_.runningAll(), &glazingReview_.runningAll()})
        progress_->follow(*slot);
    saving_.watch(workbench_.running(), [this] { return workbench_.isAwaited(); });
    for (JobSlot* slot : {&workbench_.writing(), &movies_.writing(), &answers_.scoring(),
                          &review_.runningAll(), &glazingReview_.runningAll()})
        saving_.watch(*slot, [] { return true; });
    connect(&places_, &PlaceActions::photographDropped, &photograph_, [this](const QString& file) {
        photograph_.set(GroundPictureFile{file.toStdString(), {}, {}});
    });
    connect(&places_, &PlaceActions::treesFound, &trees_, &TreeActions::ask);
    connect(&tools_, &EditTools::inventoryRequested, &trees_, &TreeActions::askForFile);
    connect(&reviews_, &ReviewActions::exportRequested, &results_, &ResultActions::askForExport);
    connect(&tools_.building(), &BuildingEditing::selectionChanged, docks_.reviewForm, [this] {
        const BuildingEditing& building = tools_.building();
        docks_.reviewForm->setSelectedBuilding(building.selected() ? QString::fromStdString(building.id())
                                                                   : QString());
    });
    connect(&reviews_, &ReviewActions::dockRequested, this, &MainWindow::showReview);
    for (JobSlot* slot :
         {&workbench_.saving(), &tools_.context().preview.working(),
          &tools_.context().preview.measuringFacades(), &time_.moments().working(), &points_.working()})
        progress_->follow(*slot, ProgressStrip::Jobs::often);
    connect(docks_.study, &StudyDock::scoreRequested, docks_.weights, &WeightsDock::score);
    docks_.study->progress().follow(workbench_.running());
    progress_->follow(workbench_.running(), ProgressStrip::Jobs::cancellable, &docks_.study->progress());
    connect(&workbench_.running(), &JobSlot::started, docks_.study, [this] {
        docks_.study->setRunning(true);
        mode_.showStudies();
        if (!panel_->legend().legend()) panel_->legend().setHint(tr("The answer is being computed"));
    });
    connect(&workbench_.running(), &JobSlot::ended, docks_.study, [this] {
        docks_.study->setRunning(false);
        if (!panel_->legend().legend()) panel_->results().show();  // with its own hint again
    });
}

// What fills the table of scenarios is seen beside it.
void MainWindow::connectScenarioJobs() {
    ScenarioTable& table = docks_.scenarios->table();
    workbench_.setScenarioTable([&table] { return table.csv(); });
    const auto follow = [this, &table](JobSlot& slot, ScenarioWork work) {
        docks_.scenarios->progress().follow(slot);
        connect(&slot, &JobSlot::ended, &table, [&table, work] { table.setWorking(work, false); });
        if (work == ScenarioWork::measuring) return;  // or it measures the displayed one alone
        connect(&slot, &JobSlot::started, &table, [&table, work] { table.setWorking(work, true); });
    };
    follow(workbench_.running(), ScenarioWork::measuring);
    follow(answers_.scoring(), ScenarioWork::scoring);
    for (JobSlot* slot : {&review_.runningAll(), &glazingReview_.runningAll()})
        follow(*slot, ScenarioWork::reviewing);
}

void MainWindow::connectWorkbench() {
    connect(&workbench_, &Workbench::cityShown, this, &MainWindow::showCity);
    connect(&workbench_, &Workbench::projectOpened, this, &MainWindow::showProject);
    connect(&workbench_, &Workbench::failed, &panel_->messages(), &MessageBar::showError);
    auto* settled = new QTimer(this);
    settled->setSingleShot(true);
    settled->setInterval(settledMs);
    connect(settled, &QTimer::timeout, this, &MainWindow::storePicture);
    connect(&opening_, &OpeningActions::opened, settled, qOverload<>(&QTimer::start));
    connect(&saving_, &SavingActions::saved, settled, qOverload<>(&QTimer::start));
    connect(&answers_, &LatestAnswers::failed, &panel_->messages(), &MessageBar::showError);
    connect(&opening_, &OpeningActions::wholeCityRequested, &panel_->navigator(),
            &ViewNavigator::showWholeCity);
    connect(&workbench_, &Workbench::noted, &panel_->messages(), &MessageBar::showNote);
    connect(&workbench_.document(), &StudyDocument::changed, this, &MainWindow::showDocument);
    connect(&workbench_.session(), &ProjectSession::unsavedChanged, this, &MainWindow::showTitle);
}

void MainWindow::connectDocks() {
    study_.listenTo(*docks_.study, *docks_.project, *docks_.weights);
    edits_.listenTo(*docks_.project, *docks_.warnings);
    connect(docks_.project, &ProjectDock::weightsChosen, this, [this](const std::string& table) {
        docks_.weights->choose(table);
        showDock(docks_.weights);
    });
    connect(docks_.places, &PlacesDock::thresholdChosen, docks_.study, &StudyDock::setEnough);
    connect(docks_.study, &StudyDock::streetsRequested, &places_, &PlaceActions::readStreets);
    connect(&display_, &ResultDisplay::elementsShown, this, [this] { showDock(docks_.elements); });
    connect(&contributions_, &ContributionLinks::dockRequested, this,
            [this] { showDock(docks_.contributions); });
    connect(docks_.project, &ProjectDock::placeSelected, &contributions_, [this](const std::string& place) {
        if (!place.empty() && docks_.contributions->isInFront()) contributions_.choose(place);
    });
    // A review's figures are below already.
    connect(&display_, &ResultDisplay::chosen, this,
            [this] { mode_.mode() == ViewMode::review ? showAnswerPanel() : showDock(docks_.results); });
    connect(&workbench_, &Workbench::ran, this, &MainWindow::showAnswerPanel);
    connect(docks_.contributions, &ContributionsDock::exportRequested, &results_,
            &ResultActions::askForContributions);
    connect(docks_.results, &ResultsDock::subjectRequested, &contributions_, &ContributionLinks::show);
    docks_.results->setActions(results_.saveResult(), scenarios_.compareAction(), results_.exportAction());
    connect(&panel_->legend(), &LegendStrip::shownChosen, this, [this] { view_.rememberShown(); });
    connect(docks_.results, &ResultsDock::commandRequested, this, [this] {
        workbench_.findCommand({.scale = panel_->legend().changeScale(),
                                .legend = panel_->legend().choice(),
                                .thresholdHours = panel_->results().thresholdHours()});
    });
    connect(docks_.results, &ResultsDock::warningsRequested, this, [this] { showDock(docks_.warnings); });
    connect(&workbench_, &Workbench::commandFound, &copying_, &CopyActions::copyCommand);
    scenarios_.setSideBySide(comparing_.actions().front());
    scenarios_.setPlacesMeasured([this] {
        if (docks_.study->kind() != StudyKind::places) return false;
        workbench_.compareAnyScenario();
        fillsTable_ = true;
        docks_.study->runByPlaceInAll();
        return true;
    });
    connect(&workbench_, &Workbench::studyStopped, this, [this] { fillsTable_ = false; });
    connect(&scenarios_, &ScenarioActions::tableRequested, this, [this] { showDock(docks_.scenarios); });
    connect(&scenarios_, &ScenarioActions::comparisonShown, this, [this] {
        mode_.showStudies();
        showDock(docks_.results);
    });
    connect(&placeLinks_, &PlaceLinks::dockRequested, this, [this] {
        docks_.study->restore(StudyKind::places);  // Run asks again what is shown
        if (std::exchange(fillsTable_, false)) return showDock(docks_.scenarios);
        showDock(docks_.places);
    });
    connect(&placeLinks_, &PlaceLinks::placeRequested, &places_, &PlaceActions::zoomTo);
    connect(&placeLinks_, &PlaceLinks::placeRequested, this, [this](const std::string& place) {
        if (docks_.contributions->isInFront()) contributions_.choose(place);
    });
    const auto showContributors = [this](const std::string& place) {
        showDock(docks_.contributions);
        contributions_.choose(place);
    };
    connect(docks_.places, &PlacesDock::dateChosen, &contributions_, &ContributionLinks::setDate);
    connect(&placeLinks_, &PlaceLinks::contributorsRequested, this, showContributors);
    connect(&display_, &ResultDisplay::contributorsRequested, this, showContributors);
    connect(&placeLinks_, &PlaceLinks::chosen, &display_, &ResultDisplay::showPlace);
    connect(&tools_, &EditTools::selectionMade, this, [this] { raiseDock(tools_.dock()); });
    connectStudyForm();
    followRegion();
    connectElementForms();
    connect(&points_, &PointInspector::asked, this, [this] { showDock(docks_.point); });
    connect(docks_.point, &PointDock::saveRequested, this, &MainWindow::savePoint);
    connect(docks_.point, &PointDock::treeRequested, &contributions_, &ContributionLinks::show);
    connect(&tools_, &EditTools::treesChosen, this, [this] { showDock(tools_.treeDock()); });
    connect(&tools_, &EditTools::designBegan, this, [this] { raiseDock(tools_.massingDock()); });
}

// Its outline is of use while a study is asked or its answer read, and in the way otherwise.
void MainWindow::followRegion() {
    QList<QDockWidget*> docks;
    for (QDockWidget* dock : findChildren<QDockWidget*>())
        if (dock->isAncestorOf(docks_.study) || dock->isAncestorOf(docks_.results)) docks << dock;
    for (QDockWidget* dock : docks)
        connect(dock, &QDockWidget::visibilityChanged, panel_, [this, dock, docks](bool isInFront) {
            dock->setProperty(inFrontProperty, isInFront);
            panel_->setRegionShown(std::ranges::any_of(
                docks, [](const QDockWidget* one) { return one->property(inFrontProperty).toBool(); }));
        });
}

void MainWindow::connectStudyForm() {
    StudyDock& form = *docks_.study;
    form.setRules(review_.library().rules());
    connect(&form, &StudyDock::kindChosen, this, &MainWindow::chooseKind);
    connect(&form, &StudyDock::paperRequested, this, [this] { useMapsOfPaper(true); });
    BuildingEditing& building = tools_.building();
    connect(&building, &BuildingEditing::selectionChanged, &form, [&form, &building] {
        form.setBuilding(building.selected() ? QString::fromStdString(building.id()) : QString());
    });
    connect(&form, &StudyDock::surroundingsRequested, &region_, [this, &building] {
        if (building.selected()) region_.takeSurroundings(*building.selected());
    });
    connect(&tools_, &EditTools::regionRequested, &region_, &RegionActions::change);
    connect(&region_, &RegionActions::taken, this, [this] { raiseDock(docks_.study); });
    form.setCityFinder([this](bool all) { return workbench_.listPlaceCities(all); });
    connect(&form, &StudyDock::sunByPlaceRequested, &workbench_, &Workbench::runByPlace);
    connect(&workbench_.session(), &ProjectSession::changed, &form, [this, &form] {
        form.setComparing(workbench_.comparing());
        const Project& project = workbench_.session().project();
        form.setPlaces(project.places, project.regions);
        form.setScenarioCount(listNames(project.scenarios).size());
    });
}

// Of a study at points and of a review of windows.
void MainWindow::connectElementForms() {
    docks_.study->setElementFinder([this](const ElementSettings& elements) {
        ProjectSession& session = workbench_.session();
        return findElementParts(elements, session.project(), *session.city()).value_or(elements);
    });
    for (ElementForm* form : {&docks_.study->elements(), &docks_.reviewForm->elements()}) {
        picking_.serve(*form);
        connect(&workbench_.session(), &ProjectSession::changed, form, [this, form] {
            QStringList lots, places;
            const Project& project = workbench_.session().project();
            for (const NamedLot& lot : project.lots) lots << QString::fromStdString(lot.name);
            for (const Place& place : project.places) places << QString::fromStdString(place.name);
            places.sort(Qt::CaseInsensitive);
            form->setNames(lots, places);
        });
    }
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

void MainWindow::connectModes() {
    connect(&mode_, &ModeSwitch::changed, this, &MainWindow::showModes);
    connect(&review_, &ReviewSession::answered, this, &MainWindow::showVerdicts);
    connect(&time_, &TimeDisplay::momentChanged, this, &MainWindow::activateExploration);
    connect(&exploration_, &Exploration::changed, this,
            [this] { panel_->results().setExplored(exploration_.answer()); });
    connect(&exploration_, &Exploration::failed, &panel_->messages(), &MessageBar::showError);
    // Where the processor draws, a moving camera leaves no time to explore.
    auto* rest = new QTimer(this);
    rest->setSingleShot(true);
    rest->setInterval(drawsInSoftware() ? cameraRestMs : 0);
    connect(rest, &QTimer::timeout, this, &MainWindow::explore);
    for (auto signal : {&CityView::poseChanged, &CityView::sectionChanged})
        connect(&panel_->view(), signal, rest, qOverload<>(&QTimer::start));
    panel_->results().setMode(mode_.mode());
    activateExploration();
}

void MainWindow::connectPreferences() {
    const auto usePaper = [this] { results_.usePaper(readPageSetup(settings_)); };
    connect(&help_, &HelpActions::tourRequested, &tours_, &TourActions::start);
    connect(&help_, &HelpActions::questionAsked, this, &MainWindow::answerCard);
    connect(&preferences_, &PreferencesActions::paperChosen, this, usePaper);
    connect(&results_, &ResultActions::saveRequested, &saving_, &SavingActions::save);
    connect(&results_, &ResultActions::setupChosen, this,
            [this](const PageSetup& setup) { savePageSetup(setup, settings_); });
    connect(&preferences_, &PreferencesActions::textsChanged, this, &MainWindow::textsChanged);
    usePaper();
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
    exploration_.setActive(mode_.mode() == ViewMode::exploration && !time_.showsMoment());
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

// The camera stays: the city may be another scenario of the same project.
void MainWindow::showCity() {
    const CameraPose pose = panel_->view().pose();
    panel_->showCity(workbench_.city());
    panel_->view().setPose(pose);
    edits_.showCity();
    exploration_.setCity(workbench_.city());
    docks_.study->setCity(workbench_.session().city());
    display_.showCity();
    showVerdicts();
    time_.offer();
    showDocument();
    study_.runAgainIfQuick();
}

// With the state of the view, what the docks show beside it, and the answers.
ProjectSaving::Compose MainWindow::projectToSave() {
    Project project = workbench_.session().project();
    project.view = view_.toSave();
    project.view[chosenWeightsKey] = docks_.weights->model().table().name;
    project.view[kindKey] = studyKindKeys[std::size_t(docks_.study->kind())];
    project.view[placesAskedKey] = docks_.study->places().choice();
    project.view[placesListedKey] = docks_.places->choice();
    const auto keep = [&project](const char* key, std::string text) {
        text.empty() ? void(project.view.erase(key)) : void(project.view[key] = std::move(text));
    };
    keep(comparedKey, comparing_.choice());
    keep(clockKey, time_.choice());
    if (std::string figures = answers_.figuresToSave(); !figures.empty())
        project.view[viewFiguresKey] = std::move(figures);
    return [project = std::move(project), measured = workbench_.measured()] {
        return withMeasured(project, measured);
    };
}

// The last message stays: recovery comes before what was assumed of the files.
void MainWindow::showProject() {
    panel_->messages().hide();
    horizons_->forget();
    saving_.takeProject();
    display_.forget();
    view_.restore();
    const auto& saved = workbench_.session().project().view;
    if (const auto weights = saved.find(chosenWeightsKey); weights != saved.end())
        docks_.weights->choose(weights->second);
    showSavedKind();
    showSavedPlaces();
    opening_.takeProject();
    showTitle();
    opening_.showGuesses();
    hideAnswerPanels();
    study_.repeatSaved();
    if (workbench_.session().recovered()) help_.closeStart();
    if (workbench_.running().busy()) showAnswerPanel();  // what was shown when it was saved
    recovery_.offer();
    const auto kept = [&saved](const char* key) {
        const auto text = saved.find(key);
        return text == saved.end() ? std::string() : text->second;
    };
    comparing_.restore(kept(comparedKey));
    if (!time_.restore(kept(clockKey)) && mode_.mode() == ViewMode::exploration) time_.showPresent();
}

// Whether a comparison is asked for follows from the baseline.
void MainWindow::showSavedKind() {
    const auto& saved = workbench_.session().project().view;
    const auto key = saved.find(kindKey);
    const auto found =
        key == saved.end() ? studyKindKeys.end() : std::ranges::find(studyKindKeys, key->second);
    if (found == studyKindKeys.end()) return;
    const auto kind = StudyKind(found - studyKindKeys.begin());
    if (kind != StudyKind::shadow && kind != StudyKind::change) docks_.study->restore(kind);
}

void MainWindow::showSavedPlaces() {
    const auto& saved = workbench_.session().project().view;
    const auto found = [&](const char* key) {
        const auto text = saved.find(key);
        return text == saved.end() ? std::string() : text->second;
    };
    docks_.study->places().restore(found(placesAskedKey));
    docks_.places->restore(found(placesListedKey));
    if (!saved.contains(kindKey)) docks_.study->beginAnew();
}

void MainWindow::showDocument() {
    const StudySettings& settings = workbench_.document().settings();
    panel_->showRegion(settings.region);
    showPaper();
    if (workbench_.city())
        exploration_.setPeriod(settings.period, makeObserver(workbench_.city()->city(), settings));
}

void MainWindow::showTitle() {
    if (!workbench_.city()) return;
    setWindowTitle(tr("%1[*] - Noonmark").arg(workbench_.projectName()));
    setWindowModified(workbench_.session().hasUnsavedWork());
}

void MainWindow::takeOver(MainWindow& before) {
    restoreGeometry(before.saveGeometry());
    restoreState(before.saveState(layoutVersion), layoutVersion);
    if (!workbench_.city()) return;
    Q_EMIT workbench_.session().changed();
    Q_EMIT workbench_.session().baselineChanged();
    showCity();
    view_.restore(parseViewState(before.view_.toSave()));
    docks_.weights->choose(before.docks_.weights->model().table().name);
    docks_.study->restore(before.docks_.study->kind());
    docks_.study->places().restore(before.docks_.study->places().choice());
    docks_.places->restore(before.docks_.places->choice());
    opening_.takeProject();
    panel_->time().choose(before.panel_->time().look());
    comparing_.restore(before.comparing_.choice());
    review_.takeOver(before.review_);
    glazingReview_.takeOver(before.glazingReview_);
    showTitle();
    before.saving_.removeRecovery();
    if (workbench_.session().hasUnsavedWork()) saving_.writeRecovery();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!saving_.confirmUnsaved([this] { close(); })) return event->ignore();
    help_.closeStart();
    settings_.setValue(QStringLiteral("geometry"), saveGeometry());
    settings_.setValue(QStringLiteral("docks"), saveState(layoutVersion));
    QMainWindow::closeEvent(event);
}

}  // namespace noonmark
