#pragma once

// Editing of buildings in the view. EditTools owns the tools and their menu entries; BuildingEditing (select,
// demolish, move, resize), TowerEditing (massing), LotEditing (outlines of lots) and MeshPlacing (a mesh file
// as a building) and TreeEditing share one EditContext: the view, the preview and the drag handle. No tool
// knows the project: each emits its edits as one undo step and gets back the changed city. EditPreview shows
// edits before they are made.

#include <QPointer>
#include <optional>
#include <vector>

#include "app/gui/tools/editing/box_selection.h"
#include "app/gui/tools/editing/building_editing.h"
#include "app/gui/tools/editing/lot_editing.h"
#include "app/gui/tools/editing/mesh_placing.h"
#include "app/gui/tools/editing/tree_editing.h"
#include "app/gui/tools/massing/massing_panel.h"
#include "app/gui/tools/massing/tower_editing.h"

class QAction;

namespace noonmark {

class PlacingPanel;
class SelectionPanel;

/// The tools that edit the city: selection, demolition, moving, towers on lots, meshes. They do not know the
/// project: they emit edits and get back the changed city.
class EditTools final : public QObject {
    Q_OBJECT
public:
    /// `view` must outlive it. `horizons` are used for the live shadow and may be shared.
    explicit EditTools(ViewPanel& view,
                       std::shared_ptr<SharedHorizonCache> horizons = std::make_shared<SharedHorizonCache>(),
                       QObject* parent = nullptr);
    ~EditTools() override;

    /// the displayed city; call it after the view shows it
    void setCity(std::shared_ptr<const OpenCity> city);
    void setLots(const std::vector<NamedLot>& lots);
    /// The latest study of the displayed city, whose map follows dragged trees; null: none.
    void setStudy(std::shared_ptr<const Study> study);
    /// The towers of the shown scenario, with their designs and storeys.
    void setTowers(std::map<std::string, ProposedTower> towers);
    void setProposals(std::vector<ImportMesh> proposals);  ///< read from files, of the shown scenario
    void setQuestion(const LiveQuestion& question);        ///< settings of the live shadow
    void setStoreyLines(bool on);                    ///< lines at the floors of proposed towers; on at first
    void heightReferenceChanged();                   ///< shows heights again (looks/units.h)
    void setFacades(const FacadeSettings& facades);  ///< bays and storeys of the live facades
    /// Shows the sunlight of the edited building's facades too; on until changeAction() is switched on.
    [[nodiscard]] QAction& facadesAction() { return *facades_; }
    /// The city that edits are compared with while they are shown, and its scenario's name; null: none.
    void setBaseline(std::shared_ptr<const City> city, const std::string& scenario);
    /// Shows the change against the baseline instead of the shadow with the edited building; off until the
    /// window's settings switch it on. It excludes facadesAction(): both have a scale of their own.
    [[nodiscard]] QAction& changeAction() { return *change_; }

    [[nodiscard]] QWidget* dock() const;  ///< panel of the selected building; its parent takes ownership
    [[nodiscard]] QWidget* massingDock() const;  ///< panel of lots and towers; likewise
    [[nodiscard]] QWidget* treeDock() const;     ///< panel of trees; likewise
    [[nodiscard]] std::vector<QAction*> actions() const { return actions_; }  ///< for a menu

    [[nodiscard]] BuildingEditing& building() { return building_; }
    [[nodiscard]] TowerEditing& tower() { return tower_; }
    [[nodiscard]] MeshPlacing& mesh() { return mesh_; }
    [[nodiscard]] LotEditing& lotEditing() { return lotEditing_; }
    [[nodiscard]] TreeEditing& trees() { return trees_; }
    [[nodiscard]] EditContext& context() { return context_; }

    void drawLot();
    /// Shows the handles of a lot's corners and sides.
    void editLot(const NamedLot& lot);
    void lotFromFootprint();
    /// Designs on this lot a copy of the tower that is selected or being designed.
    void copyTower(const NamedLot& lot);
    /// Reads a mesh as a building of the scenario and places it on the lot at this point of the ground, or
    /// there.
    void placeMesh(const QString& file, std::optional<glm::dvec2> ground);
    /// Begins a tower on the lot with the values of the last one.
    void designOn(const NamedLot& lot);
    void replace();  ///< the selected building with a tower
    /// The edits were refused: shows the unchanged city.
    void revert();
    void cancel();  ///< cancels the active tool, or else the selection

Q_SIGNALS:
    void editsMade(std::vector<noonmark::Edit> edits, QString what);  ///< one undo step
    /// Another edition of a proposal's file: it takes the place of the one with its id.
    void editionRead(noonmark::ImportMesh edition);
    void lotDrawn(noonmark::NamedLot lot);
    void lotChanged(noonmark::NamedLot lot, QString what);  ///< another outline of this name: one undo step
    void regionRequested(noonmark::Region region);          ///< of the study, around what is designed
    /// How to use the tool that has started.
    void hinted(QString text);
    /// A tower design has started: its dock should be visible.
    void designBegan();
    /// Trees were chosen, or are to be planted: their dock should be visible.
    void treesChosen();
    void inventoryRequested();  ///< trees of a file
    /// A building was selected: its dock should be visible.
    void selectionMade();
    void failed(noonmark::Error error);

private:
    void makeActions();
    void makeLiveActions();
    void showEffect(const QString& words);
    void clickNeighbour(QPointF pixel);
    QAction* action(const QString& text, const QKeySequence& keys, const QString& tip);
    void connectView();
    void connectTools();
    void connectLots();
    void connectTrees();
    void plantTrees(TreePanel::Planting planting);
    void editChosenLot();
    void editTower(const NamedLot& lot);
    [[nodiscard]] std::optional<TowerDraft> selectedDesign() const;
    void deactivateForLot();
    [[nodiscard]] bool hasTowerOn(const NamedLot& lot) const;
    void click(QPointF pixel);
    void dragBox(const QRectF& pixels);
    void dropBox(const QRectF& pixels);
    [[nodiscard]] bool isBusy() const;  ///< clicks belong to something else than the selection
    void hover(QPointF pixel);
    void key(int key);
    void extrude(double heightM);
    void extruded(double heightM);
    void takeLot(const std::vector<Footprint>& pieces);
    void emitDesign();
    void importMesh();
    void showLots();
    void showStoreys();
    [[nodiscard]] std::optional<double> previewedStoreyHeight(const Building& building) const;
    void enableActions();

    SelectionPanel* selection_;
    PlacingPanel* placing_;
    QPointer<MassingPanel> massing_;
    QPointer<TreePanel> treePanel_;
    QPointer<QWidget> dock_;
    EditContext context_;
    BuildingEditing building_;
    TowerEditing tower_;
    MeshPlacing mesh_;
    TreeEditing trees_;
    LotEditing lotEditing_;
    std::vector<QAction*> actions_;
    std::vector<QAction*> ofBuilding_;
    QAction* demolish_ = nullptr;
    QAction* editLot_ = nullptr;
    BoxSelection box_;
    bool storeyLines_ = true;
    QAction* facades_ = nullptr;
    QAction* change_ = nullptr;
};

}  // namespace noonmark
