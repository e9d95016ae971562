#pragma once

#include <QString>

#include "app/report/legend_painter.h"
#include "render/ground_picture.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// Symmetric about 0: shade that is wanted in the colour of less shadow, shadow that is unwanted in that of
/// more. The ends are where 98 % of the cells lie within; `unit` names the largest where that is more.
Legend legendOf(const Score& score);

/// Transparent where there is no receiver. O(cells).
GroundPicture scorePicture(const Score& score, double top);

/// "score +0.520 m² a m²" of the cell that holds a point; empty outside of the grid.
QString scoreText(const Score& score, glm::dvec2 point);

}  // namespace noonmark
