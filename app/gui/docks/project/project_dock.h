#pragma once

#include <QDialog>
#include <QPersistentModelIndex>
#include <QWidget>
#include <map>
#include <optional>
#include <vector>

#include "app/gui/session/project/project_changes.h"
#include "core/receivers/parcels/parcel_lines.h"

class QDoubleSpinBox;
class QMenu;
class QTreeView;

namespace noonmark {

/// The roads, water and railways along the sides of a lot: a field for the width on each side, arranged as on
/// a map.
class LotRoadsDialog final : public QDialog {
    Q_OBJECT
public:
    LotRoadsDialog(const QString& lot, const std::vector<RoadFront>& roads, QWidget* parent = nullptr);

    [[nodiscard]] std::vector<RoadFront> roads() const;  ///< clockwise from north

private:
    std::map<ParcelSide, QDoubleSpinBox*> widths_;  ///< 0: no road
    std::vector<RoadFront> before_;
};

class ProjectModel;
class ProjectSession;
struct ProjectNode;

/// The project's tree and the actions on its nodes: by key, double click and context menu.
class ProjectDock final : public QWidget {
    Q_OBJECT
public:
    explicit ProjectDock(ProjectSession& session, QWidget* parent = nullptr);  ///< `session` must outlive it

    [[nodiscard]] QTreeView& tree() { return *tree_; }
    [[nodiscard]] ProjectModel& model() { return *model_; }

    /// The action of Enter and double click: display a scenario, use a region or period, zoom to a lot or
    /// place, edit a weight table, show a saved result.
    void use(const QModelIndex& index);
    void remove(const QModelIndex& index);      ///< removes a part, or an edit of a scenario
    void duplicate(const QModelIndex& index);   ///< a scenario, lot, region, place, period or weight table
    void addScenario(const std::string& base);  ///< and displays it
    void askForRoads(const std::string& lot);   ///< opens a dialog, whose answer is one undo step
    void setKind(const std::string& place, PlaceKind kind);
    void select(ProjectPart part, const std::string& name);
    void editName(ProjectPart part,
                  const std::string& name);  ///< selects it and opens the field for its name

Q_SIGNALS:
    void regionChosen(noonmark::Region region);
    void periodChosen(noonmark::Period period);
    void lotChosen(noonmark::NamedLot lot);
    void placeChosen(const std::string& name);    ///< to be zoomed to
    void placeSelected(const std::string& name);  ///< the current node; empty: it is no place
    void viewChosen(const std::string& name);
    void resultChosen(const std::string& name);
    void weightsChosen(const std::string& name);
    void saveRegionRequested();  ///< the study's region is to be added to the project
    void savePeriodRequested();
    void saveViewRequested();
    void saveResultRequested();
    void drawLotRequested();
    void editLotRequested(noonmark::NamedLot lot);
    void drawPlaceRequested();
    void readPlacesRequested();
    void useAsRegionRequested(const std::string& place);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showMenu(QPoint at);
    void addPartActions(QMenu& menu, const QPersistentModelIndex& index, const ProjectNode& node);
    void addScenarioActions(QMenu& menu, const std::string& name);
    void addPlaceActions(QMenu& menu, const std::string& name);
    void addLotActions(QMenu& menu, const std::string& name);
    void addGroupActions(QMenu& menu, const ProjectNode& node);
    void openGroup(const QModelIndex& group);

    ProjectSession& session_;
    ProjectModel* model_;
    QTreeView* tree_;
};

}  // namespace noonmark
