#include "app/gui/frame/main_window.h"

#include <algorithm>
#include <utility>

#include "app/gui/docks/places/places_dock.h"
#include "app/gui/docks/study_form/places_form.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/docks/weights/weights_dock.h"
#include "app/gui/docks/weights/weights_model.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/time/time_strip.h"
#include "app/input/load_project.h"

namespace noonmark {

// What the window shows of a project, and saves with it.
namespace {

constexpr const char* chosenWeightsKey = "weights";     // in Project::view: the table of the dock Weights
constexpr const char* kindKey = "question";             // likewise: what the dock Study asks
constexpr const char* placesAskedKey = "places_asked";  // likewise: of which places, and which sun is enough
constexpr const char* placesListedKey = "places_listed";  // likewise: what the table of places lists
constexpr const char* comparedKey = "compared";           // likewise: two scenarios in the view
constexpr const char* clockKey = "clock";                 // likewise: the moment whose sun is shown

}  // namespace

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
    if (!review_.repeatMeasured()) study_.repeatSaved();
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

}  // namespace noonmark
