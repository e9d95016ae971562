#include "app/gui/tools/editing/edit_tools.h"

#include <QAction>
#include <algorithm>

#include "app/gui/tools/massing/massing_panel.h"
#include "app/gui/tools/massing/massing_text.h"
#include "app/gui/view/panel/ground_layers.h"
#include "core/city/meshes/mesh_section.h"
#include "core/city/terrain/building_ground.h"
#include "scenarios/massing/copy_massing.h"

namespace noonmark {

// What EditTools does with lots and the towers on them.

void EditTools::connectLots() {
    ViewPanel& panel = context_.panel;
    connect(massing_, &MassingPanel::editRequested, this, &EditTools::editLot);
    connect(&lotEditing_, &LotEditing::changed, this, &EditTools::lotChanged);
    connect(&lotEditing_, &LotEditing::failed, this, &EditTools::failed);
    connect(&lotEditing_, &LotEditing::shapeChanged, this, &EditTools::showLots);
    connect(&tower_, &TowerEditing::began, &lotEditing_, &LotEditing::end);
    connect(&mesh_, &MeshPlacing::began, &lotEditing_, &LotEditing::end);
    connect(&building_.moveTool(), &MoveTool::began, &lotEditing_, &LotEditing::end);
    connect(&building_, &BuildingEditing::selectionChanged, this, [this] {
        if (!building_.all().empty()) lotEditing_.end();
    });
    for (PolygonTool* tool : {&panel.regionTool(), &panel.lotTool(), &panel.placeTool()})
        connect(tool, &PolygonTool::activeChanged, this, [this](bool on) {
            if (on) lotEditing_.end();
        });
    connect(&panel.measureTool(), &MeasureTool::activeChanged, this, [this](bool on) {
        if (on) lotEditing_.end();
    });
}

void EditTools::setTowers(std::map<std::string, ProposedTower> towers) {
    tower_.setTowers(std::move(towers));
    showStoreys();
}

void EditTools::setStoreyLines(bool on) {
    storeyLines_ = on;
    showStoreys();
}

// Those of the towers in the city, and those of what the preview adds.
void EditTools::showStoreys() {
    if (!context_.city) return;
    std::vector<std::vector<glm::vec3>> lines;
    const City& city = context_.city->city();
    const auto add = [&](const Building& building, double storeyHeightM) {
        for (auto& ring : makeStoreyLines(building, double(findGroundUnder(building, city)), storeyHeightM))
            lines.push_back(std::move(ring));
    };
    const CityChanges& preview = context_.preview.changes();
    for (const auto& building : city.buildings) {
        if (!storeyLines_ || tower_.towers().empty()) break;
        const auto tower = tower_.towers().find(building->sourceId);
        const bool goes = std::ranges::find(preview.removed, building) != preview.removed.end();
        if (tower != tower_.towers().end() && tower->second.storeyHeightM > 0 && !goes)
            add(*building, tower->second.storeyHeightM);
    }
    for (const auto& building : preview.added)
        if (const auto height = previewedStoreyHeight(*building); storeyLines_ && height)
            add(*building, *height);
    context_.panel.view().overlay().showFloors(lines);
}

std::optional<double> EditTools::previewedStoreyHeight(const Building& building) const {
    if (tower_.draft()) return tower_.draft()->settings.storeyHeightM;
    if (mesh_.active()) return mesh_.storeyHeightM();
    const auto tower = tower_.towers().find(building.sourceId);
    if (tower == tower_.towers().end() || tower->second.storeyHeightM == 0) return std::nullopt;
    return tower->second.storeyHeightM;
}

void EditTools::setLots(const std::vector<NamedLot>& lots) {
    context_.lots = lots;
    massing_->setLots(lots);
    editLot_->setEnabled(!lots.empty());
    lotEditing_.lotsChanged();
    showLots();
}

void EditTools::showLots() {
    if (!context_.city) return;
    Region all;
    const auto& edited = lotEditing_.lot();
    for (const NamedLot& lot : context_.lots)
        all.polygons.push_back(edited && edited->name == lot.name ? edited->outline : lot.outline);
    context_.panel.view().overlay().showLines(makeGroundLines(all, context_.city->city()));
}

void EditTools::drawLot() {
    if (!context_.city) return;
    cancel();
    context_.panel.lotTool().begin();
    context_.panel.view().requestActivate();  // the view receives the keys that finish or cancel the lot
    Q_EMIT hinted(
        tr("Click the lot's corners, or type the length of a side. Shift: at right angles to the last side. "
           "Ctrl: no snapping. Double click or Enter finishes."));
}

void EditTools::editLot(const NamedLot& lot) {
    if (!context_.city) return;
    deactivateForLot();
    lotEditing_.begin(lot);
    context_.panel.view().requestActivate();  // the view receives Delete and Esc
    const QString name = QString::fromStdString(lot.name);
    const QString how =
        tr("Drag a corner or a side of %1; Ctrl: no snapping. A click on the middle of a side adds a corner, "
           "Delete removes the selected one, Esc ends.")
            .arg(name);
    Q_EMIT hinted(hasTowerOn(lot)
                      ? how + QLatin1Char(' ') + tr("Towers that were designed on it stay as they are.")
                      : how);
}

void EditTools::deactivateForLot() {
    ViewPanel& panel = context_.panel;
    for (PolygonTool* tool : {&panel.regionTool(), &panel.lotTool(), &panel.placeTool()}) tool->cancel();
    panel.measureTool().end();
    tower_.cancel();
    mesh_.cancel();
    building_.select(std::nullopt);
}

bool EditTools::hasTowerOn(const NamedLot& lot) const {
    return std::ranges::any_of(tower_.towers(), [&](const auto& tower) {
        return tower.second.design && tower.second.design->lotName == lot.name;
    });
}

void EditTools::editChosenLot() {
    const auto under = building_.lot();
    const auto drawn =
        under ? std::ranges::find(context_.lots, under->name, &NamedLot::name) : context_.lots.end();
    const auto lot = drawn != context_.lots.end() ? std::optional(*drawn) : massing_->chosenLot();
    if (lot) editLot(*lot);
}

void EditTools::takeLot(const std::vector<Footprint>& pieces) {
    if (pieces.size() > 1)
        return Q_EMIT failed({QT_TRANSLATE_NOOP("Error", "The sides of the lot cross each other"),
                              {},
                              QT_TRANSLATE_NOOP("Error", "Draw the corners in order around the lot")});
    const NamedLot lot{freeLotName(context_.lots), pieces.front()};
    Q_EMIT lotDrawn(lot);
    designOn(lot);
}

void EditTools::designOn(const NamedLot& lot) {
    const CopiedMassing start = tower_.lastValuesOn(lot.outline);
    tower_.begin(lot, {}, start.settings);
    emitDesign();
    if (const QString changes = describeCopy(start); !changes.isEmpty()) Q_EMIT hinted(changes);
}

void EditTools::editTower(const NamedLot& lot) {
    if (!context_.city) return;
    for (const auto& building : context_.city->city().buildings)
        if (const auto design = tower_.designOf(*building); design && design->lot.name == lot.name) {
            tower_.resume(*design);
            return emitDesign();
        }
}

void EditTools::lotFromFootprint() {
    if (const auto lot = building_.lot()) Q_EMIT lotDrawn(*lot);
}

std::optional<TowerDraft> EditTools::selectedDesign() const {
    if (!context_.city || !building_.selected()) return std::nullopt;
    return tower_.designOf(*context_.city->city().buildings[*building_.selected()]);
}

// A tower built here is redesigned; any other building is replaced by a new tower of the same height.
void EditTools::replace() {
    const auto lot = building_.lot();
    if (!lot) return;
    if (const auto design = selectedDesign())
        tower_.resume(*design);
    else
        tower_.begin(*lot, building_.id(), {.storeys = std::clamp(building_.storeys(), 1, maxStoreys)});
    emitDesign();
}

void EditTools::copyTower(const NamedLot& lot) {
    if (!context_.city) return;
    auto design = tower_.draft();
    if (!design && building_.selected())
        design = tower_.designToCopy(*context_.city->city().buildings[*building_.selected()]);
    if (!design)
        return Q_EMIT failed(
            {"No tower is selected whose massing is known",
             {},
             "Select a tower that was designed on a lot; imported meshes and towers of older "
             "project files have no massing to copy"});
    if (design->lot.outline == lot.outline)
        return Q_EMIT failed({"The tower stands on this lot already", lot.name, "Choose another lot"});
    const auto copy = copyMassing(design->lot.outline, design->settings, lot.outline);
    if (!copy) return Q_EMIT failed(copy.error());
    tower_.cancel();
    tower_.resume({lot, copy->settings, freeTowerName(context_.city->city()), {}});
    emitDesign();
    if (const QString changes = describeCopy(*copy); !changes.isEmpty()) Q_EMIT hinted(changes);
}

void EditTools::emitDesign() {
    context_.panel.view().requestActivate();  // the view receives a typed height
    Q_EMIT designBegan();
    Q_EMIT hinted(
        tr("Drag the arrow or type a height. Shift: do not snap to storeys. Enter builds, Esc "
           "cancels."));
}

}  // namespace noonmark
