#pragma once

#include <QObject>
#include <cstdint>
#include <optional>
#include <string>

#include "core/receivers/receivers.h"
#include "scenarios/edits/edit.h"

class QAction;
class QWidget;

namespace noonmark {

class EditTools;
class ModeSwitch;
class ProjectDock;
class ViewPanel;
class WarningsDock;
class Workbench;
struct NamedLot;

/// Undo and redo, and the edit tools: each of their edits becomes an undo step of the project.
class EditActions final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    EditActions(Workbench& workbench, EditTools& tools, const ModeSwitch& mode, ViewPanel& panel);

    void listenTo(ProjectDock& tree, WarningsDock& warnings);  ///< both ask for edits or for a building

    void showCity();  ///< the view shows another city: the tools edit it from now on

    [[nodiscard]] QList<QAction*> undoActions() const { return {undo_, redo_}; }
    [[nodiscard]] QList<QAction*> toolActions() const;

private:
    void connectTools();
    void showProject();
    void take(const std::vector<Edit>& edits, const QString& what);
    void moveRegion(const Region& region);
    [[nodiscard]] std::optional<Region> regionToFollow(const std::vector<Edit>& edits) const;
    void reload(const ImportMesh& edition);
    void changeLot(const NamedLot& lot, const QString& what);
    void askLive();
    void setBaseline();
    void showBuilding(const QString& where);

    Workbench& workbench_;
    EditTools& tools_;
    const ModeSwitch& mode_;
    ViewPanel& panel_;
    QAction* undo_;
    QAction* redo_;
};

class ResultActions;
class ResultsDock;

/// Edit > Copy: the table, list or text that has the focus, else the picture of the view.
class CopyActions final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    CopyActions(ResultActions& results, ResultsDock& figures, ViewPanel& panel);

    [[nodiscard]] QList<QAction*> actions() const { return {copy_, figures_, picture_}; }

    /// Copies what `focus` shows; false if it shows nothing that can be copied as text.
    bool copyText(QWidget* focus);
    void copyCommand(const QString& command);

private:
    void copy();
    void copyFigures();
    void put(const QString& text, const QString& what);

    ResultActions& results_;
    ResultsDock& dock_;
    ViewPanel& panel_;
    QAction* copy_;
    QAction* figures_;
    QAction* picture_;
};

/// The building that a warning's place names: "way 264768896", "midtown.osm.pbf: relation 12, height". Its
/// id, or that of one of its parts, must occur as a whole word; if several do, the longest counts. Nothing if
/// none does. O(buildings).
std::optional<std::uint32_t> buildingNamed(const City& city, const std::string& where);

}  // namespace noonmark
