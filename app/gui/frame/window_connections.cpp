#include "app/gui/frame/main_window.h"

#include <QDockWidget>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/docks/contributions/contributions_dock.h"
#include "app/gui/docks/elements/elements_dock.h"
#include "app/gui/docks/places/places_dock.h"
#include "app/gui/docks/point/point_dock.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/docks/review/review_form.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/docks/scenarios/scenarios_dock.h"
#include "app/gui/docks/sheets/sheet_form.h"
#include "app/gui/docks/study_form/element_form.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/docks/weights/weights_dock.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/input/load_project.h"
#include "render/view/traced_city.h"

namespace noonmark {

// What the objects of the window tell each other.
namespace {

constexpr const char* inFrontProperty = "noonmarkInFront";  // of a dock: it is seen among its tabs
constexpr int cameraRestMs = 150;
constexpr int settledMs = 2500;  // after opening, until the first picture is complete

}  // namespace

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

void MainWindow::connectModes() {
    connect(&mode_, &ModeSwitch::changed, this, &MainWindow::showModes);
    connect(&review_, &ReviewSession::answered, this, &MainWindow::showVerdicts);
    connect(&time_, &TimeDisplay::momentChanged, this, &MainWindow::activateExploration);
    const EditPreview& preview = tools_.context().preview;
    connect(&preview, &EditPreview::shownChanged, &time_, &TimeDisplay::setDesigning);
    connect(&preview, &EditPreview::shownChanged, this, &MainWindow::activateExploration);
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

}  // namespace noonmark
