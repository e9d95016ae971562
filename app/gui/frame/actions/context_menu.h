#pragma once

#include <QMenu>
#include <memory>

#include "render/view/scene_picker.h"

namespace noonmark {

class EditTools;
class PlaceActions;
class PointInspector;
class RegionActions;
class ViewPanel;
class Workbench;
struct Place;

/// The menu at the right mouse button in the view: what can be done with the building, the place and the
/// ground under the cursor. Not while a polygon is drawn, whose end the right button is.
class ContextMenu final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    ContextMenu(Workbench& workbench, EditTools& tools, RegionActions& region, PlaceActions& places,
                PointInspector& points, ViewPanel& panel);

    /// The menu for what lies under a pixel of the view; without entries where there is nothing.
    [[nodiscard]] std::unique_ptr<QMenu> makeMenu(QPointF pixel);

private:
    void popUp(QPointF pixel);
    void addBuilding(QMenu& menu, std::uint32_t building);
    void addPlaces(QMenu& menu, glm::dvec2 at);
    void addLots(QMenu& menu, glm::dvec2 at);
    void addGround(QMenu& menu, const Pick& pick);

    Workbench& workbench_;
    EditTools& tools_;
    RegionActions& region_;
    PlaceActions& places_;
    PointInspector& points_;
    ViewPanel& panel_;
};

}  // namespace noonmark
