#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/engines/api/surface_engine.h"
#include "core/engines/ray/visible_surface.h"
#include "render/view/view_ray.h"

namespace noonmark {

/// Shadow on everything that a camera sees: ground, roofs and facades, one sample every `spacingPx` pixels of
/// the view.
struct ExploredView {
    PixelCamera camera;                             ///< its pixels are the samples
    int spacingPx = 1;                              ///< device pixels of the view from sample to sample
    std::shared_ptr<const VisibleSurface> surface;  ///< where the samples lie; not null
    /// One a point of `surface`: over the days done, or, of points that wait for their turn, what is known of
    /// their surroundings so far; NaN: nothing.
    SurfaceShadow shadow;
    int daysDone = 0;            ///< of every point
    std::size_t pointsDone = 0;  ///< the first ones, of the days that follow
    int daysShown = 0;           ///< behind every value of `shadow`, at least
    int days = 1;                ///< of the period
    std::string running;         ///< what of the period `shadow` tells instead, while it is found; else empty

    /// How far samples lie apart at the camera's `distanceM`, metres across the line of sight.
    [[nodiscard]] double sampleM(double distanceM) const;

    /// The point of `surface` at the pixel of this place; none where that pixel saw another surface, or none.
    /// O(log points).
    [[nodiscard]] std::optional<std::size_t> pointAt(glm::dvec3 place) const;
};

/// The camera of a view with one pixel every `spacingPx`; it sees as much as the view, or a little more to
/// the sides. `lens` in device pixels.
PixelCamera makeExploredCamera(const CameraPose& pose, const ViewLens& lens, int spacingPx);

}  // namespace noonmark
