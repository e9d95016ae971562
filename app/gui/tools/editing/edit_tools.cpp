#include "app/gui/tools/editing/edit_tools.h"

#include <QAction>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/looks/theme.h"
#include "app/gui/tools/editing/mesh_placing.h"
#include "app/gui/tools/editing/selection_panel.h"
#include "app/gui/tools/massing/massing_panel.h"

namespace noonmark {

EditTools::EditTools(ViewPanel& view, std::shared_ptr<SharedHorizonCache> horizons, QObject* parent)
    : QObject(parent),
      selection_(new SelectionPanel),
      placing_(new PlacingPanel),
      massing_(new MassingPanel),
      treePanel_(new TreePanel),
      dock_(new QWidget),
      context_(view, std::move(horizons)),
      building_(context_, *selection_),
      tower_(context_, *massing_),
      mesh_(context_, *placing_),
      trees_(context_, *treePanel_),
      lotEditing_(context_),
      box_(view.view()) {
    auto* column = new QVBoxLayout(dock_);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(placing_);
    column->addWidget(selection_, 1);
    placing_->hide();
    makeActions();
    connectView();
    connectTools();
    connectLots();
    connectTrees();
    enableActions();
}

// Panels that were not placed in a dock are still owned here.
EditTools::~EditTools() {
    for (QWidget* dock :
         {dock_.data(), static_cast<QWidget*>(massing_.data()), static_cast<QWidget*>(treePanel_.data())})
        if (dock && !dock->parent()) delete dock;
}

QWidget* EditTools::dock() const { return dock_; }

QWidget* EditTools::massingDock() const { return massing_; }

QWidget* EditTools::treeDock() const { return treePanel_; }

QAction* EditTools::action(const QString& text, const QKeySequence& keys, const QString& tip) {
    auto* made = new QAction(text, this);
    made->setShortcut(keys);
    made->setToolTip(tip);
    made->setStatusTip(tip);
    actions_.push_back(made);
    return made;
}

void EditTools::makeActions() {
    const auto draw =
        action(tr("Draw &lot"), QKeySequence(tr("Ctrl+L")),
               tr("Click corners on the ground, or type the length of a side; Shift: right angles, Ctrl: no "
                  "snapping; Enter finishes, Esc cancels"));
    editLot_ =
        action(tr("Edit lot &shape"), QKeySequence(tr("Ctrl+Shift+L")),
               tr("Drag the corners and sides of the lot that is chosen in the panel Tower, or that the "
                  "selected building stands on"));
    demolish_ =
        action(tr("&Demolish"), Qt::Key_Delete, tr("Removes the selected building, or all of several"));
    const auto replace = action(tr("Replace by &tower"), QKeySequence(tr("Ctrl+T")),
                                tr("Replaces the selected building by a tower on its lot or footprint"));
    const auto move =
        action(tr("&Move building"), Qt::Key_M, tr("Drag the selected building over the ground"));
    const auto lot =
        action(tr("Lot from foot&print"), {}, tr("Creates a lot from the selected building's outline"));
    const auto plant = action(tr("Plant trees"), {}, tr("Each click on the ground plants a tree; Esc ends"));
    const auto row = action(tr("Plant a row of trees"), {},
                            tr("Click the corners of a line; a double click or Enter plants trees along it"));
    const auto mesh =
        action(tr("&Import mesh..."), {}, tr("Adds a building from a mesh file, placed by a click"));
    ofBuilding_ = {replace, move, lot};
    draw->setIcon(makeIcon(QStringLiteral("lot")));
    demolish_->setIcon(makeIcon(QStringLiteral("delete")));
    replace->setIcon(makeIcon(QStringLiteral("tower")));
    connect(draw, &QAction::triggered, this, &EditTools::drawLot);
    connect(editLot_, &QAction::triggered, this, &EditTools::editChosenLot);
    connect(demolish_, &QAction::triggered, &building_, &BuildingEditing::demolish);
    connect(replace, &QAction::triggered, this, &EditTools::replace);
    connect(move, &QAction::triggered, this, [this] { building_.setMoving(true); });
    connect(lot, &QAction::triggered, this, &EditTools::lotFromFootprint);
    connect(mesh, &QAction::triggered, this, &EditTools::importMesh);
    connect(plant, &QAction::triggered, this, [this] { plantTrees(TreePanel::Planting::single); });
    connect(row, &QAction::triggered, this, [this] { plantTrees(TreePanel::Planting::row); });
    makeLiveActions();
}

void EditTools::makeLiveActions() {
    facades_ = action(tr("Li&ve facades"), QKeySequence(tr("Shift+F")),
                      tr("Shows the sunlight of a building's facades while it is designed or changed"));
    change_ =
        action(tr("Live change"), QKeySequence(tr("Shift+L")),
               tr("While a building is edited: show the change against the baseline instead of all shadow"));
    for (QAction* one : {facades_, change_}) one->setCheckable(true);
    facades_->setChecked(true);
    connect(facades_, &QAction::toggled, this, [this](bool on) {
        if (on) change_->setChecked(false);
        context_.preview.showFacades(on);
    });
    connect(change_, &QAction::toggled, this, [this](bool on) {
        if (on) facades_->setChecked(false);
        context_.preview.showChange(on);
    });
    connect(facades_, &QAction::toggled, massing_, &MassingPanel::setFacadesShown);
    connect(change_, &QAction::toggled, massing_, &MassingPanel::setChangeShown);
    connect(massing_, &MassingPanel::facadesShownChosen, facades_, &QAction::setChecked);
    connect(massing_, &MassingPanel::changeShownChosen, change_, &QAction::setChecked);
}

void EditTools::connectView() {
    ViewNavigator& navigator = context_.panel.navigator();
    connect(&navigator, &ViewNavigator::clicked, this, &EditTools::click);
    connect(&navigator, &ViewNavigator::boxDragged, this, &EditTools::dragBox);
    connect(&navigator, &ViewNavigator::boxDropped, this, &EditTools::dropBox);
    connect(&navigator, &ViewNavigator::hovered, this, &EditTools::hover);
    connect(&navigator, &ViewNavigator::left, this, [this] { building_.hover(std::nullopt); });
    connect(&context_.panel, &ViewPanel::keyPressed, this, &EditTools::key);
    connect(&context_.panel.lotTool(), &PolygonTool::finished, this, &EditTools::takeLot);
    connect(&context_.handle, &ExtrudeHandle::dragged, this, &EditTools::extrude);
    connect(&context_.handle, &ExtrudeHandle::dropped, this, &EditTools::extruded);
}

void EditTools::connectTools() {
    const auto made = [this](const std::vector<Edit>& edits, const QString& what, const std::string& id) {
        building_.selectNext(id);
        Q_EMIT editsMade(edits, what);
    };
    connect(&building_, &BuildingEditing::editsMade, this, &EditTools::editsMade);
    connect(&building_, &BuildingEditing::selectionChanged, this, &EditTools::enableActions);
    connect(&building_.moveTool(), &MoveTool::began, this,
            [this] { Q_EMIT hinted(tr("Drag the building over the ground. Esc ends the tool.")); });
    connect(selection_, &SelectionPanel::replaceRequested, this, &EditTools::replace);
    connect(selection_, &SelectionPanel::lotRequested, this, &EditTools::lotFromFootprint);
    connect(selection_, &SelectionPanel::importRequested, this, &EditTools::importMesh);
    connect(massing_, &MassingPanel::drawRequested, this, &EditTools::drawLot);
    connect(massing_, &MassingPanel::designRequested, this, &EditTools::designOn);
    connect(massing_, &MassingPanel::editTowerRequested, this, &EditTools::editTower);
    connect(massing_, &MassingPanel::copyRequested, this, &EditTools::copyTower);
    connect(&context_.preview, &EditPreview::hinted, this, &EditTools::hinted);
    connect(&context_.preview, &EditPreview::effectChanged, this, &EditTools::showEffect);
    connect(&context_.preview, &EditPreview::effectAged, massing_, &MassingPanel::greyEffect);
    connect(&context_.preview, &EditPreview::shapeChanged, this, &EditTools::showStoreys);
    connect(&tower_, &TowerEditing::editsMade, this, made);
    connect(&tower_, &TowerEditing::regionRequested, this, &EditTools::regionRequested);
    connect(&tower_, &TowerEditing::began, &building_, &BuildingEditing::deactivate);
    connect(&tower_, &TowerEditing::began, &mesh_, &MeshPlacing::cancel);
    connect(&tower_, &TowerEditing::ended, &building_, &BuildingEditing::show);
    connect(&mesh_, &MeshPlacing::editsMade, this, made);
    connect(&mesh_, &MeshPlacing::editionRead, this, &EditTools::editionRead);
    connect(&mesh_, &MeshPlacing::failed, this, &EditTools::failed);
    connect(&mesh_, &MeshPlacing::began, &tower_, &TowerEditing::cancel);
    const auto place = [this](bool placing) {
        placing_->setVisible(placing);
        selection_->setVisible(!placing);
        if (placing) Q_EMIT selectionMade();  // both panels share a dock
    };
    connect(&mesh_, &MeshPlacing::began, this, [place] { place(true); });
    connect(&mesh_, &MeshPlacing::ended, this, [place] { place(false); });
}

void EditTools::setProposals(std::vector<ImportMesh> proposals) { context_.proposals = std::move(proposals); }

void EditTools::setStudy(std::shared_ptr<const Study> study) { context_.study = std::move(study); }

void EditTools::connectTrees() {
    connect(&trees_, &TreeEditing::hinted, this, &EditTools::hinted);
    connect(&trees_, &TreeEditing::editsMade, this, &EditTools::editsMade);
    connect(&trees_, &TreeEditing::failed, this, &EditTools::failed);
    connect(treePanel_, &TreePanel::inventoryRequested, this, &EditTools::inventoryRequested);
    connect(&trees_, &TreeEditing::chosen, this, [this] {
        building_.select(std::nullopt);
        Q_EMIT treesChosen();
    });
    connect(&building_, &BuildingEditing::selectionChanged, this, [this] {
        if (!building_.all().empty()) trees_.chooseNone();
    });
}

void EditTools::plantTrees(TreePanel::Planting planting) {
    if (!context_.city) return;
    cancel();
    trees_.plant(planting);
    Q_EMIT hinted(
        planting == TreePanel::Planting::row
            ? tr("Click the corners of a line. A double click or Enter plants trees along it, Esc "
                 "ends.")
            : tr("Click where trees are to stand; their measures are in the panel Trees. Esc ends."));
}

void EditTools::setCity(std::shared_ptr<const OpenCity> city) {
    const bool another = !context_.city || context_.city->arrays != city->arrays;
    context_.city = city;
    context_.preview.setCity(std::move(city));
    building_.cityChanged();
    trees_.cityChanged();
    if (another) {
        lotEditing_.end();
        tower_.cancel();
        mesh_.cancel();
    } else {
        tower_.show();
        mesh_.show();
    }
    showLots();
    showStoreys();
}

void EditTools::heightReferenceChanged() {
    tower_.show();
    building_.show();
}

void EditTools::setQuestion(const LiveQuestion& question) {
    context_.preview.setQuestion(question);
    tower_.showInRegion();
}

void EditTools::setBaseline(std::shared_ptr<const City> city, const std::string& scenario) {
    context_.preview.setBaseline(std::move(city), scenario);
}

// In both docks, and the first lines beside the cursor that drags, below the measures: three lines in all.
void EditTools::showEffect(const QString& words) {
    context_.panel.cursorLabel().setLinesBelow(words.section(u'\n', 0, 1));
    selection_->showEffect(words);
    massing_->showEffect(words);
}

void EditTools::setFacades(const FacadeSettings& facades) { context_.preview.setFacades(facades); }

void EditTools::enableActions() {
    for (QAction* one : ofBuilding_) one->setEnabled(building_.selected().has_value());
    demolish_->setEnabled(!building_.all().empty());
    const auto design = selectedDesign();
    selection_->setDesigned(design.has_value());
    if (design) massing_->chooseLot(design->lot.name);
    if (!building_.all().empty()) Q_EMIT selectionMade();
}

void EditTools::click(QPointF pixel) {
    if (!context_.city || context_.panel.drawing() || lotEditing_.active()) return;
    if (tower_.active()) return clickNeighbour(pixel);
    const ViewNavigator& navigator = context_.panel.navigator();
    if (mesh_.active()) {
        if (const auto ground = navigator.groundAt(pixel)) mesh_.placeAt({ground->x, ground->y});
        return;
    }
    if (trees_.click(pixel)) return;
    const auto pick = navigator.pickAt(pixel);
    const auto building = pick ? pick->building : std::nullopt;
    if (!navigator.clickModifiers().testFlag(Qt::ControlModifier)) return building_.select(building);
    if (building) building_.toggle(*building);
}

bool EditTools::isBusy() const {
    return !context_.city || context_.panel.drawing() || tower_.active() || mesh_.active() ||
           lotEditing_.active();
}

void EditTools::dragBox(const QRectF& pixels) {
    if (!isBusy()) box_.show(pixels.translated(context_.panel.navigator().pictureLeft(), 0));
}

void EditTools::dropBox(const QRectF& pixels) {
    box_.hide();
    if (isBusy()) return;
    const CityView& view = context_.panel.view();
    building_.selectAll(
        findBuildingsIn(pixels, context_.city->city(), view.pose(), view.lens(), view.section()));
}

void EditTools::clickNeighbour(QPointF pixel) {
    const auto pick = context_.panel.navigator().pickAt(pixel);
    if (!pick || !pick->building || !facades_->isChecked()) return;
    const auto& buildings = context_.city->city().buildings;
    if (*pick->building < buildings.size()) context_.preview.toggleNeighbour(buildings[*pick->building]);
}

void EditTools::hover(QPointF pixel) {
    lotEditing_.hover(pixel);
    trees_.hover(pixel);
    if (isBusy() || trees_.isPlanting()) return building_.hover(std::nullopt);
    const auto pick = context_.panel.navigator().pickAt(pixel);
    building_.hover(pick ? pick->building : std::nullopt);
}

void EditTools::key(int key) {
    if (lotEditing_.key(key) || context_.handle.key(key)) return;
    if (trees_.key(key)) return;
    if (key == Qt::Key_Escape) cancel();
    const bool enter = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (enter && tower_.active()) tower_.build();
    if (enter && mesh_.active()) mesh_.build();
}

void EditTools::revert() {
    context_.preview.clear();
    building_.show();
}

void EditTools::cancel() {
    if (lotEditing_.active()) return lotEditing_.end();
    if (tower_.active()) return tower_.cancel();
    if (mesh_.active()) return mesh_.cancel();
    if (trees_.cancel()) return;
    if (context_.city) building_.endTool();
}

void EditTools::extrude(double heightM) {
    if (tower_.active())
        tower_.setHeight(heightM);
    else
        building_.previewHeight(heightM);
}

void EditTools::extruded(double heightM) {
    if (!tower_.active()) building_.takeHeight(heightM);
}

void EditTools::placeMesh(const QString& file, std::optional<glm::dvec2> ground) {
    if (!context_.city) return;
    cancel();
    const auto lot = std::ranges::find_if(
        context_.lots, [&ground](const NamedLot& one) { return ground && contains(one.outline, *ground); });
    if (lot != context_.lots.end()) {
        Building outline;
        outline.parts.push_back({.footprint = lot->outline});
        ground = findMiddle(outline);
    }
    mesh_.begin(file, ground);
}

void EditTools::importMesh() {
    const QString file = context_.city ? askForMesh(dock_) : QString();
    if (!file.isEmpty()) mesh_.begin(file);
}

}  // namespace noonmark
