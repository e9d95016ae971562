#pragma once

#include <QObject>

#include "core/receivers/region.h"

class QAction;

namespace noonmark {

class Exploration;
class HeightColours;
class ProjectDock;
class SectionDialog;
class ViewPanel;
class Workbench;

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
