#pragma once

#include <QString>

#include "render/scene/ground_picture.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// The score as a picture for the ground, transparent where there is no receiver. O(cells).
GroundPicture scorePicture(const Score& score, double top);

/// "score +0.520 m² a m²" of the cell that contains a point; empty outside the grid.
QString formatScore(const Score& score, glm::dvec2 point);

}  // namespace noonmark
