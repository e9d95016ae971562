#pragma once

#include <QObject>

#include "core/receivers/receivers.h"

class QAction;
class QLabel;
class QSettings;

namespace noonmark {

class ViewPanel;
class Workbench;

/// Colours the buildings in the view by where their heights come from, with a legend below the view, on
/// request.
class HeightColours final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive this object.
    HeightColours(Workbench& workbench, ViewPanel& panel);

    [[nodiscard]] QAction* action() const { return action_; }  ///< checkable
    [[nodiscard]] QLabel* legend() const { return legend_; }   ///< hidden while off

private:
    void refresh();

    Workbench& workbench_;
    ViewPanel& panel_;
    QAction* action_;
    QLabel* legend_;
};

class EditTools;

/// How proposed towers are shown: lines at their floors, heights above the ground or above the datum, and the
/// change while they are designed (on at first). The switches are remembered in the settings.
class TowerDisplay final : public QObject {
    Q_OBJECT
public:
    TowerDisplay(QSettings& settings, EditTools& tools);  ///< both outlive it

    [[nodiscard]] QAction* storeyLines() const { return storeyLines_; }  ///< checkable
    [[nodiscard]] QAction* aboveDatum() const { return aboveDatum_; }    ///< checkable

private:
    void setStoreyLines(bool on);
    void setAboveDatum(bool on);

    QSettings& settings_;
    EditTools& tools_;
    QAction* storeyLines_;
    QAction* aboveDatum_;
};

class Exploration;
class ProjectDock;
class SectionDialog;

/// Moves the camera, and changes how buildings are drawn and the view is explored.
class ViewActions final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    ViewActions(Workbench& workbench, ViewPanel& panel, Exploration& exploration, ProjectDock& tree);

    [[nodiscard]] QList<QAction*> cameraActions() const {
        return {wholeCity_, northUp_, fromAbove_, region_};
    }
    [[nodiscard]] QAction* solidBuildings() const { return faces_; }  ///< checkable
    [[nodiscard]] QAction* mapOnGround() const { return map_; }       ///< checkable
    [[nodiscard]] QAction* trees() const { return trees_; }           ///< checkable
    [[nodiscard]] QAction* exploreByMaps() const { return byMaps_; }  ///< checkable
    [[nodiscard]] QAction* measure() const { return measure_; }       ///< checkable
    [[nodiscard]] HeightColours& heightColours() const { return *heights_; }
    [[nodiscard]] QAction* sectionBox() const { return section_; }  ///< checkable

private:
    void showRegion();
    void setMeasuring(bool on);
    void setSection(bool on);

    Workbench& workbench_;
    ViewPanel& panel_;
    QAction* wholeCity_;
    QAction* northUp_;
    QAction* fromAbove_;
    QAction* region_;
    QAction* faces_;
    QAction* trees_;
    QAction* map_;
    QAction* byMaps_;
    QAction* measure_;
    QAction* section_;
    HeightColours* heights_;                  ///< a child of this object
    SectionDialog* sectionDialog_ = nullptr;  ///< from the first use on; a child of the panel
};

/// `region` with some ground around it: what the view shows at first, and what it shows of a lot.
Box2 boxAround(const Region& region);

}  // namespace noonmark
