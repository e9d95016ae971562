#include "app/gui/frame/actions/edit_actions.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QUndoStack>
#include <cctype>
#include <glm/common.hpp>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/docks/export/table_text.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/frame/actions/result_actions.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/view_presets.h"
#include "app/input/load_city.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/impact/proposal_region.h"

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
    connect(&workbench_, &Workbench::answered, this, [this] { tools_.setStudy(workbench_.study()); });
    connect(&mode_, &ModeSwitch::changed, this, &EditActions::askLive);
    connect(&workbench_.document(), &StudyDocument::changed, this, &EditActions::askLive);
    connect(&workbench_.session(), &ProjectSession::baselineChanged, this, &EditActions::askLive);
}

void EditActions::connectTools() {
    connect(&tools_, &EditTools::editsMade, this, &EditActions::take);
    connect(&tools_, &EditTools::editionRead, this, &EditActions::reload);
    connect(&tools_, &EditTools::lotDrawn, this,
            [this](const NamedLot& lot) { workbench_.session().addLot(lot); });
    connect(&tools_, &EditTools::lotChanged, this, &EditActions::changeLot);
    connect(&workbench_.session(), &ProjectSession::changed, this, &EditActions::showProject);
    connect(&tools_, &EditTools::failed, &panel_.messages(), &MessageBar::showError);
}

void EditActions::take(const std::vector<Edit>& edits, const QString& what) {
    const auto region = regionToFollow(edits);
    QUndoStack& undo = workbench_.document().undoStack();
    if (region) undo.beginMacro(what);
    const bool isDone = workbench_.session().addEdits(edits, what);
    if (!isDone) tools_.revert();
    if (region && isDone) moveRegion(*region);
    if (region) undo.endMacro();
}

void EditActions::moveRegion(const Region& region) {
    StudySettings settings = workbench_.document().settings();
    settings.region = region;
    workbench_.document().change(settings, tr("region"));
    panel_.messages().showNote(
        tr("The study's region is now around what you built; Study > Where changes it"));
}

// Around the first proposal, where nothing was measured in the region that every city begins with. The park
// of the sample is a region of its own.
std::optional<Region> EditActions::regionToFollow(const std::vector<Edit>& edits) const {
    const auto& open = workbench_.city();
    const Region& region = workbench_.document().settings().region;
    const bool isAsked = !open || workbench_.answer() || !workbench_.measured().empty() ||
                         !workbench_.session().project().results.empty();
    if (isAsked || region != firstRegion(open->loaded)) return std::nullopt;
    const auto& files = open->loaded.files;
    if (files.size() == 1 && isParkSample(files.front())) return std::nullopt;
    const auto edited = applyEdits(open->city(), edits);
    if (!edited || findInRegion(edited->changes.added, region) == InRegion::whole) return std::nullopt;
    return makeRegionAround(edited->changes.added, region, open->city().frame.origin().latDeg);
}

// Where its earlier edition stands among the edits of a scenario: those that follow apply to the new one.
void EditActions::reload(const ImportMesh& edition) {
    Project next = workbench_.session().project();
    replaceImports(next.scenarios, edition);
    const QString what = tr("reload %1").arg(QString::fromStdString(edition.file));
    if (!workbench_.session().change(std::move(next), what)) tools_.revert();
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
    std::vector<ImportMesh> proposals;
    if (edits)
        for (const Edit& edit : *edits)
            if (const auto* mesh = std::get_if<ImportMesh>(&edit)) proposals.push_back(*mesh);
    tools_.setProposals(std::move(proposals));
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
    tools_.setStudy(workbench_.study());
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

CopyActions::CopyActions(ResultActions& results, ResultsDock& figures, ViewPanel& panel)
    : results_(results),
      dock_(figures),
      panel_(panel),
      copy_(makeAction(this, tr("&Copy"), QKeySequence::Copy,
                       tr("The table or text last clicked, else the picture of the view"), "copy")),
      figures_(makeAction(this, tr("Copy fi&gures"), {}, tr("The figures of the panel Results, as a table"))),
      picture_(makeAction(this, tr("C&opy picture"), QKeySequence(tr("Ctrl+Shift+C")),
                          tr("The view with title, legend, scale and north"), "picture")) {
    connect(copy_, &QAction::triggered, this, &CopyActions::copy);
    connect(figures_, &QAction::triggered, this, &CopyActions::copyFigures);
    connect(picture_, &QAction::triggered, &results_, &ResultActions::copyPicture);
    dock_.setContextMenuPolicy(Qt::ActionsContextMenu);
    dock_.addAction(figures_);
}

void CopyActions::copy() {
    if (!copyText(QApplication::focusWidget())) results_.copyPicture();
}

bool CopyActions::copyText(QWidget* focus) {
    if (const auto* label = qobject_cast<QLabel*>(focus); label && label->hasSelectedText()) {
        put(label->selectedText(), tr("Text"));
        return true;
    }
    for (QWidget* widget = focus; widget; widget = widget->parentWidget()) {
        if (const auto* view = qobject_cast<QAbstractItemView*>(widget)) {
            const QModelIndexList rows = view->selectionModel()->selectedIndexes();
            const bool several = !rows.isEmpty() && rows.first().row() != rows.last().row();
            put(makeTableText(*view->model(), several ? rows : QModelIndexList()), tr("Table"));
            return true;
        }
        if (widget == &dock_ && !dock_.rows().empty()) {
            copyFigures();
            return true;
        }
    }
    return false;
}

void CopyActions::copyFigures() {
    if (dock_.rows().empty())
        return panel_.messages().showError({QT_TRANSLATE_NOOP("Error", "There are no figures to copy"),
                                            {},
                                            QT_TRANSLATE_NOOP("Error", "Press Run first")});
    put(makeTableText(dock_.rows()), tr("Figures"));
}

void CopyActions::copyCommand(const QString& command) { put(command, tr("Command")); }

void CopyActions::put(const QString& text, const QString& what) {
    QApplication::clipboard()->setText(text);
    panel_.messages().showNote(tr("%1 copied").arg(what));
}

namespace {

bool isOfWord(const std::string& text, std::size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
}

bool holdsWord(const std::string& text, const std::string& word) {
    if (word.empty()) return false;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const bool begins = at == 0 || !isOfWord(text, at - 1);
        if (begins && !isOfWord(text, at + word.size())) return true;
    }
    return false;
}

}  // namespace

std::optional<std::uint32_t> buildingNamed(const City& city, const std::string& where) {
    std::optional<std::uint32_t> found;
    std::size_t longest = 0;
    const auto look = [&](std::uint32_t building, const std::string& id) {
        if (id.size() <= longest || !holdsWord(where, id)) return;
        found = building;
        longest = id.size();
    };
    for (std::uint32_t i = 0; i < city.buildings.size(); ++i) {
        look(i, city.buildings[i]->sourceId);
        for (const Part& part : city.buildings[i]->parts) look(i, part.sourceId);
    }
    return found;
}

}  // namespace noonmark
