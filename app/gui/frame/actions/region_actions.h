#pragma once

#include <QObject>

#include "core/receivers/receivers.h"

class QAction;
class QWidget;

namespace noonmark {

class ProjectDock;
class StudyDock;
class ViewPanel;
class Workbench;

/// Changes the region of the study: drawn, read from a file, the visible ground, the whole city, or a region
/// or place of the project; and saves it in the project.
class RegionActions final : public QObject {
    Q_OBJECT
public:
    /// Dialogs belong to `window`. All must outlive this object.
    RegionActions(Workbench& workbench, ViewPanel& panel, StudyDock& study, ProjectDock& tree,
                  QWidget& window);

    [[nodiscard]] QList<QAction*> actions() const { return {draw_, fromFile_}; }

    /// The surroundings of a building (index in the displayed city) as the region: its box, widened by four
    /// times its height, and by 50 m at least.
    void takeSurroundings(std::uint32_t building);
    void takeNamed(const std::string& name);  ///< a region of the project, or a place
    void change(const Region& region);

Q_SIGNALS:
    void taken();  ///< by the user, who wants to see it: drawn, named, read from a file

private:
    void connectDocks(ProjectDock& tree);
    void draw(bool on);
    void takeDrawn(const std::vector<Footprint>& pieces);
    void takeWholeCity();
    void listNames();
    void readFile();
    void saveInProject();

    Workbench& workbench_;
    ViewPanel& panel_;
    StudyDock& study_;
    QWidget& window_;
    QAction* draw_;
    QAction* fromFile_;
};

}  // namespace noonmark
