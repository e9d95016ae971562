#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "core/engines/ray/visible_surface.h"

namespace noonmark {

/// What a camera saw of the surfaces, drawn onto the surfaces themselves: it stays there while the view moves
/// on, and covers nothing that this camera did not see.
struct SurfacePicture {
    PixelCamera camera;
    /// One a pixel of the camera, row 0 the TOP: place in local metres, and share of the palette, 0 to 1;
    /// below 0: nothing is known there.
    std::vector<glm::vec4> samples;
    bool soFar = false;  ///< true for a part of the period only: shown with stripes
};

}  // namespace noonmark
