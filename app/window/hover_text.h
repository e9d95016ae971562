#pragma once

#include <QString>

#include "core/study/study.h"
#include "render/scene_picker.h"

namespace noonmark {

/// What lies under the cursor, for the status bar: place in degrees and local metres, the building with its
/// height, or the minutes of shadow of the ground there. `study` may be null.
QString hoverText(const Pick& pick, const City& city, const Study* study);

/// The grid cell that holds a point; none outside.
std::optional<std::size_t> cellAt(const Grid& grid, glm::dvec2 point);

}  // namespace noonmark
