#pragma once

#include <QPointer>
#include <vector>

#include "app/window/massing/building_editing.h"
#include "app/window/massing/massing_panel.h"
#include "app/window/massing/mesh_placing.h"
#include "app/window/massing/tower_editing.h"

class QAction;

namespace noonmark {

class PlacingPanel;
class SelectionPanel;

/// The tools that change the city: selecting, demolishing, moving, towers on lots, meshes. They know no
/// project: what they make goes out as edits, and comes back as another city.
class EditTools final : public QObject {
    Q_OBJECT
public:
    /// `view` outlives it; `horizons` of the live shadow may be shared with whoever else asks them.
    explicit EditTools(ViewPanel& view,
                       std::shared_ptr<SharedHorizonCache> horizons = std::make_shared<SharedHorizonCache>(),
                       QObject* parent = nullptr);
    ~EditTools() override;

    void setCity(std::shared_ptr<const OpenCity> city);  ///< what the view shows, after it shows it
    void setLots(const std::vector<NamedLot>& lots);
    void setQuestion(const LiveQuestion& question);  ///< of the live shadow

    [[nodiscard]] QWidget* dock() const;         ///< the selected building; whoever places it owns it
    [[nodiscard]] QWidget* massingDock() const;  ///< lots and towers; owned in the same way
    [[nodiscard]] std::vector<QAction*> actions() const { return actions_; }  ///< for a menu

    [[nodiscard]] BuildingEditing& building() { return building_; }
    [[nodiscard]] TowerEditing& tower() { return tower_; }
    [[nodiscard]] MeshPlacing& mesh() { return mesh_; }
    [[nodiscard]] EditSession& workspace() { return desk_; }

    void drawLot();
    void lotFromFootprint();
    void replace();   ///< the selected building by a tower
    void takeBack();  ///< the edits were refused: the city is shown as it is
    void cancel();    ///< the tool at work, else the selection

Q_SIGNALS:
    void editsMade(std::vector<noonmark::Edit> edits, QString what);  ///< one step of undo
    void lotDrawn(noonmark::NamedLot lot);
    void hinted(QString text);  ///< mouse and keys of the tool that begins
    void designBegan();         ///< the dock for it should be in sight
    void selectionMade();       ///< in the same way
    void failed(noonmark::Error error);

private:
    void makeActions();
    QAction* action(const QString& text, const QKeySequence& keys, const QString& tip);
    void connectView();
    void connectTools();
    void click(QPointF pixel);
    void hover(QPointF pixel);
    void key(int key);
    void extrude(double heightM);
    void extruded(double heightM);
    void takeLot(const std::vector<Footprint>& pieces);
    void tellOfDesign();
    void importMesh();
    void showLots();
    void enableActions();

    SelectionPanel* selection_;
    PlacingPanel* placing_;
    QPointer<MassingPanel> massing_;
    QPointer<QWidget> dock_;
    EditSession desk_;
    BuildingEditing building_;
    TowerEditing tower_;
    MeshPlacing mesh_;
    std::vector<QAction*> actions_;
    std::vector<QAction*> ofBuilding_;
};

}  // namespace noonmark
