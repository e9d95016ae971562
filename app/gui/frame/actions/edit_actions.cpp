#include "app/gui/frame/actions/edit_actions.h"

#include <QAction>
#include <QUndoStack>
#include <glm/common.hpp>

#include "app/gui/base/looks/icons.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/results/warnings_dock.h"
#include "app/gui/session/study/warning_place.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/view/panel/mode_switch.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

EditActions::EditActions(Workbench& workbench, EditTools& tools, const ModeSwitch& mode, ViewPanel& panel)
    : workbench_(workbench),
      tools_(tools),
      mode_(mode),
      panel_(panel),
      undo_(workbench.document().undoStack().createUndoAction(this)),
      redo_(workbench.document().undoStack().createRedoAction(this)) {
    undo_->setShortcut(QKeySequence::Undo);
    redo_->setShortcut(QKeySequence::Redo);
    undo_->setIcon(makeIcon(QStringLiteral("undo")));
    redo_->setIcon(makeIcon(QStringLiteral("redo")));
    connectTools();
    connect(&mode_, &ModeSwitch::changed, this, &EditActions::askLive);
    connect(&workbench_.document(), &StudyDocument::changed, this, &EditActions::askLive);
    connect(&workbench_.session(), &ProjectSession::baselineChanged, this, &EditActions::askLive);
}

void EditActions::connectTools() {
    connect(&tools_, &EditTools::editsMade, this,
            [this](const std::vector<Edit>& edits, const QString& what) {
                if (!workbench_.session().addEdits(edits, what)) tools_.takeBack();
            });
    connect(&tools_, &EditTools::lotDrawn, this,
            [this](const NamedLot& lot) { workbench_.session().addLot(lot); });
    connect(&tools_, &EditTools::lotChanged, this, &EditActions::changeLot);
    connect(&workbench_.session(), &ProjectSession::changed, this, &EditActions::showProject);
    connect(&tools_, &EditTools::failed, &panel_.messages(), &MessageBar::showError);
}

// A refused outline goes back to that of the project.
void EditActions::changeLot(const NamedLot& lot, const QString& what) {
    ProjectSession& session = workbench_.session();
    if (!session.change(withOutline(session.project(), lot.name, lot.outline), what)) showProject();
}

// The lots, the towers of the scenario that is shown, and the places of the live change.
void EditActions::showProject() {
    const ProjectSession& session = workbench_.session();
    tools_.setLots(session.project().lots);
    const auto edits = collectEdits(session.project().scenarios, session.scenario());
    tools_.setTowers(edits ? findProposedTowers(*edits) : std::map<std::string, ProposedTower>());
    askLive();
}

void EditActions::listenTo(ProjectDock& tree, WarningsDock& warnings) {
    connect(&tree, &ProjectDock::drawLotRequested, &tools_, &EditTools::drawLot);
    connect(&tree, &ProjectDock::editLotRequested, &tools_, &EditTools::editLot);
    connect(&warnings, &WarningsDock::placeChosen, this, &EditActions::showBuilding);
}

QList<QAction*> EditActions::toolActions() const {
    const auto& actions = tools_.actions();
    return {actions.begin(), actions.end()};
}

void EditActions::showCity() {
    tools_.setCity(workbench_.city());
    askLive();
}

// In analysis and ray reference modes the live shadow uses the cells of the study.
void EditActions::askLive() {
    if (!workbench_.city()) return;
    const StudySettings& settings = workbench_.document().settings();
    tools_.setQuestion({{settings.period, makeObserver(workbench_.city()->city(), settings)},
                        settings.region,
                        settings.receivers,
                        mode_.mode() != ViewMode::exploration,
                        workbench_.session().project().places});
    const auto& elements = workbench_.document().elements();
    tools_.setFacades(elements ? elements->facades : FacadeSettings());
    setBaseline();
}

// The existing city, unless another baseline is chosen.
void EditActions::setBaseline() {
    ProjectSession& session = workbench_.session();
    const std::string baseline = session.baseline().empty() ? existingCity : session.baseline();
    tools_.setBaseline(session.cityOf(baseline).value_or(nullptr), baseline);
}

// Goes to the building that a warning refers to, and selects it.
void EditActions::showBuilding(const QString& where) {
    if (!workbench_.city()) return;
    const City& city = workbench_.city()->city();
    const auto building = buildingNamed(city, where.toStdString());
    if (!building)
        return panel_.messages().showNote(tr("%1 is not a building of the displayed city").arg(where));
    Box2 box = bounds(*city.buildings[*building]);
    const glm::vec2 border = glm::max((box.high - box.low) * 1.5F, glm::vec2(40.0F));
    box = {box.low - border, box.high + border};
    panel_.navigator().showSlanting(box);
    tools_.building().select(building);
}

}  // namespace noonmark
