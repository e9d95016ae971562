#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/engines/api/engine.h"
#include "core/engines/ray/visible_surface.h"
#include "render/view/camera_pose.h"

namespace noonmark {

/// Shadow on all surfaces that a camera sees (ground, roofs and facades), one sample every `spacingPx`
/// pixels.
struct ExploredView {
    PixelCamera camera;                             ///< one sample per pixel of this camera
    int spacingPx = 1;                              ///< device pixels of the view between samples
    std::shared_ptr<const VisibleSurface> surface;  ///< positions of the samples; not null
    /// One value per point of `surface`, over the days done. Points that are still waiting have the value
    /// known from their surroundings so far; NaN: none.
    SurfaceShadow shadow;
    int daysDone = 0;            ///< for every point
    std::size_t pointsDone = 0;  ///< number of points done for the next days, from the first point on
    int daysShown = 0;           ///< minimum number of days behind every value of `shadow`
    int days = 1;                ///< of the period
    std::string running;         ///< text on the part of the period that `shadow` shows during a computation;
                                 ///< otherwise empty

    /// Distance between samples at `distanceM` from the camera, metres perpendicular to the line of sight.
    [[nodiscard]] double sampleM(double distanceM) const;

    /// The point of `surface` at the pixel that shows `place`; empty where that pixel saw another surface or
    /// none. O(log points).
    [[nodiscard]] std::optional<std::size_t> pointAt(glm::dvec3 place) const;
};

/// A camera for a view with one pixel every `spacingPx`. It sees the same as the view, or slightly more at
/// the sides. `lens` in device pixels.
PixelCamera makeExploredCamera(const CameraPose& pose, const ViewLens& lens, int spacingPx);

}  // namespace noonmark
