#pragma once

#include "render/view/camera_pose.h"

namespace noonmark {

/// Limits of the camera.
struct CameraLimits {
    static constexpr double minPitchDeg = 2;
    static constexpr double clearanceM = 1.7;  ///< minimum height of the eye above the ground
    double nearestM = 5;                       ///< shortest distance to the target
    double furthestM = 50000;
    Box2 box;                    ///< the target stays within it
    double lowM = 0, highM = 0;  ///< heights between which the target of a level parallel view stays
};

CameraLimits computeLimits(const ViewBounds& bounds);

/// The whole city from the south, looking obliquely down.
CameraPose wholeCity(const ViewBounds& bounds, const ViewLens& lens);

/// A box on the ground from straight above, north up.
CameraPose fromAbove(const Box2& box, double groundM, const ViewLens& lens);

/// Rotates around the target; dragging across the full width of the window is half a turn.
CameraPose orbit(const CameraPose& pose, glm::dvec2 dragPx, const ViewLens& lens);

/// In a parallel projection the same rotation around `pivot`, which stays under its pixel; else around the
/// target.
CameraPose orbit(const CameraPose& pose, const glm::dvec3& pivot, glm::dvec2 dragPx, const ViewLens& lens);

/// Moves the camera so that the ground under `fromPx` comes to lie under `toPx`; in a parallel projection,
/// everything.
CameraPose pan(const CameraPose& pose, glm::dvec2 fromPx, glm::dvec2 toPx, const ViewLens& lens);

/// Moves towards `point`, which stays under the same pixel; factor < 1 moves closer.
CameraPose zoom(const CameraPose& pose, glm::dvec3 point, double factor);

/// Moves over the ground by shares of the distance to the target, to the right and ahead in the view
/// direction; in a parallel projection, up on the screen.
CameraPose moveCamera(const CameraPose& pose, double right, double ahead);

/// The same pose in another projection; what lies on the ground in the middle stays there.
CameraPose project(CameraPose pose, Projection projection, const GroundHeight& ground);

/// The same pose with its target on the ground and within the limits, and its eye above the ground. Where
/// needed the pitch increases, which raises the eye. A parallel projection may be level; its picture stays
/// the same unless it is beyond the limits.
CameraPose keepAboveGround(CameraPose pose, const CameraLimits& limits, const GroundHeight& ground);

}  // namespace noonmark
