#pragma once

#include <QObject>
#include <QTimer>
#include <map>
#include <optional>

#include "app/gui/session/study/open_city.h"
#include "app/gui/tools/preview/edit_preview.h"
#include "app/gui/view/panel/point_input.h"
#include "app/gui/view/panel/view_panel.h"
#include "core/city/building_heights.h"
#include "render/view/camera_pose.h"
#include "render/view/view_navigator.h"
#include "scenarios/edits/edit.h"
#include "scenarios/massing/tower_design.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// Height above `foot`, metres, of the point on its vertical nearest to a view ray: the height that a handle
/// on that vertical is dragged to. Nothing if the ray is within 8 degrees of the vertical or leads away from
/// it: there one pixel would cover too many metres.
std::optional<double> heightOnVertical(const ViewRay& ray, glm::dvec3 foot);

/// The nearest whole number of storeys, at least one, as a height in metres; at most 2000 m.
double roundToStoreys(double heightM, double storeyM);

/// The nearest height that a massing may have: in steps of 0.1 m, from one storey to 2000 m.
double roundHeight(double heightM, double storeyM);

class ViewPanel;

/// The arrow on top of a tower. Dragging it up or down sets the height, snapped to whole storeys, or free
/// with Shift. A height typed over the view, from the reference in use (looks/units.h), "40",
/// "131' 3\"" or "40 m", followed by Enter, sets it too.
class ExtrudeHandle final : public QObject, public DragTarget {
    Q_OBJECT
public:
    explicit ExtrudeHandle(ViewPanel& panel, QObject* parent = nullptr);  ///< `panel` must outlive it
    ~ExtrudeHandle() override;

    struct Tower {
        glm::dvec3 foot{0};  ///< on the ground, under the handle
        double heightM = 0;
        double storeyM = defaultStoreyM;
        double groundElevationM = 0;  ///< of the foot, above the datum: heights may be typed from there
    };
    void place(const Tower& tower);
    void hide();
    [[nodiscard]] bool shown() const { return tower_.has_value(); }
    [[nodiscard]] bool dragging() const { return grabbedM_.has_value(); }

    /// Text beside the cursor during a drag.
    void showFigures(const QString& figures);

    bool grab(QPointF pixel) override;
    void dragTo(QPointF pixel) override;
    void drop() override;

    /// True if the key was part of a typed number, or ended one.
    bool key(int key);

Q_SIGNALS:
    void dragged(double heightM);  ///< at most once per frame
    void dropped(double heightM);  ///< the drag or the typing has ended

private:
    [[nodiscard]] std::optional<double> heightAt(QPointF pixel) const;
    [[nodiscard]] double metresUp(QPointF pixel) const;
    [[nodiscard]] bool isAt(QPointF pixel) const;
    void follow();
    void takeTyped();
    void showTyped();

    ViewPanel& panel_;
    std::optional<Tower> tower_;
    std::optional<double> grabbedM_;  // from the handle to where it was grabbed
    bool fromAbove_ = false;          // seen from above: the drag is measured in pixels
    QPointF pixel_;
    QTimer next_;  // combines several mouse moves into one frame
    TypedLength typed_;
    ShortcutClaim claim_;
};

struct Study;

/// State shared by the edit tools: the view, its city, the preview and the drag handle.
struct EditContext {
    EditContext(ViewPanel& view, std::shared_ptr<SharedHorizonCache> horizons)
        : panel(view), preview(view, std::move(horizons)), handle(view) {}

    ViewPanel& panel;
    EditPreview preview;
    ExtrudeHandle handle;
    std::shared_ptr<const OpenCity> city;  ///< null before the first city
    std::shared_ptr<const Study> study;    ///< the latest of that city; null: none
    std::vector<NamedLot> lots;
    std::map<std::string, ProposedTower> towers;  ///< of the shown scenario
    std::vector<ImportMesh> proposals;            ///< read from files, of the same

    /// Null: it was not designed here.
    [[nodiscard]] const ProposedTower* findTower(const Building& building) const {
        const auto found = towers.find(building.sourceId);
        return found == towers.end() ? nullptr : &found->second;
    }
};

}  // namespace noonmark
