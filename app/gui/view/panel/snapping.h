#pragma once

#include <QString>
#include <memory>

#include "app/gui/session/study/open_city.h"
#include "app/gui/view/panel/snap_targets.h"
#include "render/view/city_view.h"

namespace noonmark {

/// Snaps points on the ground of a view to corners and edges nearby, and marks where. Not while Ctrl is held.
class Snapping {
public:
    explicit Snapping(CityView& view) : view_(view) {}  ///< `view` must outlive it

    /// The buildings to snap to; they are arranged at the next find().
    void setCity(std::shared_ptr<const OpenCity> city);
    void setLots(std::vector<Footprint> lots);

    /// Snaps a point of the ground and marks what it found; see SnapTargets::find().
    std::optional<Snap> find(const glm::dvec3& ground, std::span<const glm::dvec2> line = {});
    void clearMark();

private:
    CityView& view_;
    std::shared_ptr<const OpenCity> city_;
    std::vector<Footprint> lots_;
    std::optional<SnapTargets> targets_;  ///< empty until find() needs them
};

/// The map from ground to screen around a point of the ground.
SnapReach computeSnapReach(const CameraPose& pose, const ViewLens& lens, const glm::dvec3& ground);

QString describeSnap(SnapKind kind);  ///< "corner", "edge"

}  // namespace noonmark
