#pragma once

#include <QObject>

class QAction;

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

}  // namespace noonmark
