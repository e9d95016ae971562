#pragma once

#include "render/view/view_ray.h"

namespace noonmark {

/// Ends of what the user may do with the camera.
struct CameraLimits {
    static constexpr double lowestPitchDeg = 2;
    static constexpr double clearanceM = 1.7;  ///< the eye stays this far above the ground
    double nearestM = 5;                       ///< shortest distance to the target
    double furthestM = 50000;
    Box2 box;  ///< the target stays within it
};

CameraLimits computeLimits(const ViewBounds& bounds);

/// The whole city, seen from the south, slanting down.
CameraPose wholeCity(const ViewBounds& bounds, const ViewLens& lens);

/// All of a box on the ground from straight above, north up.
CameraPose fromAbove(const Box2& box, double groundM, const ViewLens& lens);

/// Turned around the target: a full width of the window is half a turn.
CameraPose orbit(const CameraPose& pose, glm::dvec2 dragPx, const ViewLens& lens);

/// Moved so that the ground that was under `fromPx` comes to lie under `toPx`.
CameraPose pan(const CameraPose& pose, glm::dvec2 fromPx, glm::dvec2 toPx, const ViewLens& lens);

/// Moved towards `point`, which stays under the same pixel; factor < 1 comes nearer.
CameraPose zoom(const CameraPose& pose, glm::dvec3 point, double factor);

/// Moved over the ground by shares of the distance: `right` and `ahead` as the camera is turned.
CameraPose moved(const CameraPose& pose, double right, double ahead);

/// The same pose with its target on the ground and within the limits, and its eye above the ground: raised
/// by looking down more steeply where needed.
CameraPose keepAboveGround(CameraPose pose, const CameraLimits& limits, const GroundHeight& ground);

}  // namespace noonmark
