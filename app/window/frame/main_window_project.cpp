#include <QAction>
#include <QDateTime>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>

#include "app/window/frame/main_window.h"
#include "app/window/project/project_dock.h"
#include "app/window/project/scenario_table.h"
#include "app/window/project/scenarios_dock.h"
#include "app/window/project/weights_dock.h"
#include "app/window/study/open_options.h"
#include "app/window/study/results_dock.h"
#include "app/window/study/study_dock.h"
#include "app/window/view/view_panel.h"
#include "app/window/widgets/file_dialogs.h"
#include "core/study/text/height_words.h"

// The part of MainWindow that connects the project to menus, tree and view: scenarios, saving, recovery.
namespace noonmark {

namespace {

// The extent shown when a project opens: the region with a margin.
Box2 startView(const Region& region) {
    const Box2 box = bounds(region);
    const glm::vec2 border = (box.high - box.low) * 0.15F;
    return {box.low - border, box.high + border};
}

LonLat findMiddle(const City& city) {
    const Box2 box = bounds(city);
    if (box.empty()) return city.frame.origin();
    return city.frame.lonLatFromLocal((glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0);
}

}  // namespace

void MainWindow::connectProject() {
    connectTree();
    connectScenarios();
    connectSaving();
}

void MainWindow::connectTree() {
    const ProjectDock* tree = docks_.project;
    connect(tree, &ProjectDock::regionChosen, this, &MainWindow::changeRegion);
    connect(tree, &ProjectDock::periodChosen, this, [this](const Period& period) {
        StudySettings settings = workbench_.document().settings();
        settings.period = period;
        workbench_.document().change(settings, tr("period"));
    });
    connect(tree, &ProjectDock::lotChosen, this, [this](const NamedLot& lot) {
        panel_->navigator().showSlanting(startView({lot.name, {lot.outline}}));
    });
    connect(tree, &ProjectDock::resultChosen, &workbench_, &Workbench::showSaved);
    connect(tree, &ProjectDock::weightsChosen, this, [this](const std::string& table) {
        docks_.weights->choose(table);
        raiseDock(docks_.weights);
    });
    connect(docks_.weights, &WeightsDock::scoreRequested, &workbench_, &Workbench::runScore);
    connect(tree, &ProjectDock::keepRegionRequested, this, &MainWindow::keepRegion);
    connect(tree, &ProjectDock::keepPeriodRequested, this, &MainWindow::keepPeriod);
    connect(tree, &ProjectDock::keepResultRequested, this, &MainWindow::keepResult);
}

void MainWindow::connectScenarios() {
    ProjectSession& session = workbench_.session();
    connect(menus_.newScenario, &QAction::triggered, this, [this] { docks_.project->addScenario({}); });
    connect(menus_.newFromThis, &QAction::triggered, this,
            [this] { docks_.project->addScenario(workbench_.session().scenario()); });
    connect(menus_.compare, &QAction::triggered, this,
            [this](bool on) { workbench_.session().compareWith(on ? existingCity : std::string()); });
    connect(menus_.measureAll, &QAction::triggered, &workbench_, &Workbench::measureAll);
    connect(menus_.keepResult, &QAction::triggered, this, &MainWindow::keepResult);
    connect(docks_.scenarios, &ScenariosDock::measureAllRequested, &workbench_, &Workbench::measureAll);
    connect(&session, &ProjectSession::baselineChanged, this, &MainWindow::compare);
    connect(&session, &ProjectSession::changed, this, [this] {
        menus_.compare->setChecked(workbench_.session().baseline() == existingCity);
        docks_.scenarios->table().setStudies(workbench_.studies(), workbench_.document().settings());
        showOutdated();
    });
}

void MainWindow::connectSaving() {
    connect(menus_.save, &QAction::triggered, this, &MainWindow::save);
    connect(menus_.saveAs, &QAction::triggered, this, &MainWindow::saveAs);
    connect(&workbench_.session(), &ProjectSession::unsavedChanged, this, &MainWindow::showTitle);
    connect(&saving_, &ProjectSaving::saved, this, [this](const QString& file) {
        recent_.add({file});
        if (std::exchange(leftTaken_, false)) place_.forgetLeft();
        panel_->messages().showNote(tr("Saved as %1").arg(file));
        if (const auto then = std::exchange(afterSave_, nullptr)) then();
    });
    connect(&saving_, &ProjectSaving::failed, this, [this](const Error& error) {
        afterSave_ = nullptr;
        panel_->messages().showError(error);
        panel_->messages().offer(tr("Save as..."), [this] { saveAs(); });
    });
    connect(&workbench_, &Workbench::tookUp, &saving_, &ProjectSaving::takeUp);
    connect(&saving_, &ProjectSaving::notSaved, &panel_->messages(), &MessageBar::showError);
}

// Whether an action that ends the current work may proceed now: nothing is unsaved, or the user discards it.
// False if the user cancels or saves first; in the latter case `afterSave` is called after the save. An
// action that waited for an earlier save is dropped.
bool MainWindow::maySafely(const std::function<void()>& afterSave) {
    afterSave_ = nullptr;
    if (!workbench_.session().hasUnsavedWork()) {
        saving_.forgetUnsaved();
        return true;
    }
    const Unsaved answer = askUnsaved_();
    if (answer == Unsaved::discard) discardWork();
    if (answer != Unsaved::save) return answer == Unsaved::discard;
    afterSave_ = afterSave;
    save();
    return false;
}

// Runs `then` once no work can be lost: at once, after a save, or never.
void MainWindow::whenSafe(const std::function<void()>& then) {
    if (maySafely([this, then] { whenSafe(then); })) then();
}

// Also removes the recovery file that the work came from; otherwise it would be offered again.
void MainWindow::discardWork() {
    saving_.discardUnsaved();
    if (std::exchange(leftTaken_, false)) place_.forgetLeft();
}

MainWindow::Unsaved MainWindow::askUnsaved() {
    const auto answer = QMessageBox::question(
        this, tr("Unsaved changes"), tr("Save changes to %1?").arg(projectName()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save) return Unsaved::save;
    return answer == QMessageBox::Discard ? Unsaved::discard : Unsaved::cancel;
}

void MainWindow::save() {
    if (!workbench_.session().file()) return saveAs();
    saving_.save();
}

void MainWindow::saveAs() {
    if (!workbench_.city()) return;
    const QString file = askSaveAs_(projectName() + QLatin1String(projectEnding));
    if (file.isEmpty()) return void(afterSave_ = nullptr);
    saving_.saveAs(file.toStdString());
}

QString MainWindow::projectName() {
    const auto& file = workbench_.session().file();
    QString name = file ? QString::fromStdString(file->path().filename().string())
                        : RecentFiles::nameOf(opening_.join(QLatin1Char('\n')));
    name.remove(QStringLiteral("sample:"));
    name.remove(QLatin1String(projectEnding));
    return name.isEmpty() ? tr("Untitled") : name;
}

void MainWindow::showTitle() {
    if (!workbench_.city()) return;
    setWindowTitle(tr("%1[*] - Noonmark").arg(projectName()));
    setWindowModified(workbench_.session().hasUnsavedWork());
}

ProjectSaving::View MainWindow::viewNow() {
    const ProjectSession& session = workbench_.session();
    ViewState state{.camera = panel_->view().pose(),
                    .mode = mode_.mode(),
                    .measure = panel_->legend().measure(),
                    .changeScale = panel_->legend().changeScale(),
                    .scenario = session.scenario(),
                    .baseline = session.baseline(),
                    .study = workbench_.document().settings()};
    if (workbench_.shown() == Workbench::Shown::comparison) state.answer = "comparison";
    if (workbench_.shown() == Workbench::Shown::study) state.answer = "study";
    if (!state.answer.empty()) state.answerSeconds = workbench_.answerSeconds();
    return textsOf(state);
}

void MainWindow::showProject() {
    const ViewState& view = workbench_.openedView();
    const bool saved = workbench_.session().file().has_value();
    panel_->messages().hide();
    afterSave_ = nullptr;
    saving_.projectReplaced();
    leftTaken_ = workbench_.session().recovered();
    answerShown_ = false;
    mode_.setAnalysisEngine(StudySettings().engine);
    options_->setMiddle(findMiddle(workbench_.city()->city()));
    if (saved) mode_.setMode(view.mode);
    if (saved) panel_->legend().setMeasure(view.measure);
    panel_->legend().setChangeScale(view.changeScale);
    if (view.camera)
        panel_->view().setPose(*view.camera);
    else
        panel_->navigator().showSlanting(startView(workbench_.document().settings().region));
    if (!opening_.isEmpty()) recent_.add(opening_, reading_);
    showTitle();
    showGuesses();
    answerAsSaved();
    offerRecovery();
}

// Reports assumptions that are not in the files: heights and time zone.
void MainWindow::showGuesses() {
    const CityRead& read = workbench_.city()->loaded.read;
    const auto heights = makeAssumedHeightsMessage(countHeights(read.city), read.heights);
    const ZoneGuess& zone = workbench_.zone();
    QStringList lines;
    if (heights) lines << QString::fromStdString(*heights) + u'.';
    if (!zone.others.isEmpty() && !workbench_.openedView().study)
        lines << tr("The time zone %1 is a guess; %2 is also nearby.")
                     .arg(zone.zone, zone.others.join(QStringLiteral(", ")));
    if (lines.isEmpty()) return;
    panel_->messages().showHelp(lines.join(u'\n'));
    if (!heights || opening_.isEmpty() || workbench_.session().file()) return;
    panel_->messages().offer(tr("Open with options..."), [this] { options_->ask(opening_, reading_); });
}

// The project file holds no results except saved ones. A quick result is recomputed at once; for a slow one
// the results dock says how to compute it again.
void MainWindow::answerAsSaved() {
    const ViewState& view = workbench_.openedView();
    docks_.results->setHint(tr("No study yet."));
    if (view.answer.empty()) return;
    if (view.mode != ViewMode::exploration && view.answerSeconds < quickSeconds) return workbench_.run();
    docks_.results->setHint(
        view.answer == "comparison"
            ? tr("%1 was compared with %2 when the project was saved. Run (Ctrl+R) repeats the comparison, "
                 "in %3.")
                  .arg(QString::fromStdString(view.scenario), QString::fromStdString(view.baseline),
                       describeAbout(view.answerSeconds))
            : tr("A study was shown when the project was saved. Run (Ctrl+R) computes it again, in %1.")
                  .arg(describeAbout(view.answerSeconds)));
}

void MainWindow::offerRecovery() {
    const auto& file = workbench_.session().file();
    if (!file) return offerLeftWork();
    const auto found = recoveryOf(file->path());
    if (!found) return offerOlderWork();
    panel_->messages().showHelp(
        tr("Noonmark closed before %1 was saved. Unsaved changes can be recovered.").arg(projectName()));
    panel_->messages().offer(tr("Recover"), [this, path = file->path(), offered = *found] {
        std::error_code gone;
        const bool moved = std::filesystem::last_write_time(offered.path, gone) != offered.at;
        workbench_.recover(moved || gone ? ProjectSaving::olderRecovery(path) : offered.path);
    });
    if (std::filesystem::exists(ProjectSaving::olderRecovery(file->path())))
        panel_->messages().offerToo(tr("Older changes..."), [this] { offerOlderWork(); });
}

// Offers an older recovery file, which was moved aside when a newer one was written.
void MainWindow::offerOlderWork() {
    const auto& file = workbench_.session().file();
    if (!file) return;
    const std::filesystem::path older = ProjectSaving::olderRecovery(file->path());
    const QFileInfo info(QString::fromStdString(older.string()));
    if (!info.exists()) return;
    panel_->messages().showHelp(
        tr("There are unsaved changes to %1 from %2. They can be recovered or deleted.")
            .arg(projectName(), info.lastModified().toString(QStringLiteral("yyyy-MM-dd HH:mm"))));
    panel_->messages().offer(tr("Recover"), [this, older] { workbench_.recover(older); });
    panel_->messages().offerToo(tr("Delete them"), [older] {
        std::error_code none;
        std::filesystem::remove(older, none);
    });
}

void MainWindow::offerLeftWork() {
    if (!place_.left() || leftTaken_) return;
    panel_->messages().showHelp(
        tr("Noonmark closed before a project was saved. The unsaved project can be recovered."));
    panel_->messages().offer(tr("Recover"), [this] {
        whenSafe([this] {
            opening_.clear();
            workbench_.recoverUntitled(*place_.left());
        });
    });
}

void MainWindow::keepRegion() {
    Project next = workbench_.session().project();
    Region region = workbench_.document().settings().region;
    region.name = freeName(next, ProjectPart::region, region.name.empty() ? "Region" : region.name);
    const QString what = tr("save region %1").arg(QString::fromStdString(region.name));
    next.regions.push_back(std::move(region));
    workbench_.session().change(std::move(next), what);
}

void MainWindow::keepPeriod() {
    Project next = workbench_.session().project();
    const Period& period = workbench_.document().settings().period;
    const std::string name = freeName(next, ProjectPart::period, formatText(period.start));
    next.periods.push_back({name, period});
    workbench_.session().change(std::move(next), tr("save period %1").arg(QString::fromStdString(name)));
}

}  // namespace noonmark
