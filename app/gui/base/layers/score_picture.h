#pragma once

#include <QString>

#include "core/measures/colour_scale.h"
#include "render/scene/ground_picture.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// The score as a picture for the ground, transparent where there is no receiver, and where it is 0.
/// O(cells).
GroundPicture scorePicture(const Score& score, const ColourScale& scale);

/// "score +0.520 m² a m²" of the cell that contains a point; empty outside the grid.
QString formatScore(const Score& score, glm::dvec2 point);

}  // namespace noonmark
