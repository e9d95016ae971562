#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "core/engines/ray/visible_surface.h"

namespace noonmark {

/// The surfaces that a camera saw, with a value per pixel, drawn onto the surfaces themselves. The picture
/// stays in place while the view moves; it does not cover what this camera did not see.
struct SurfacePicture {
    PixelCamera camera;
    /// One per pixel of the camera, row 0 the TOP: position in local metres and share of the palette, 0 to 1;
    /// below 0: unknown.
    std::vector<glm::vec4> samples;
    bool soFar = false;  ///< covers only a part of the period: shown with stripes
};

}  // namespace noonmark
