#pragma once

#include <QString>
#include <optional>

#include "core/engines/api/shadow_field.h"
#include "render/view/scene_picker.h"

namespace noonmark {

/// What lies under the cursor, for the status bar: place in degrees and local metres, the building with its
/// height, and `minutes` of shadow there, where known.
QString hoverText(const Pick& pick, const City& city, const QString& minutes);

/// "gross 60.0 min a day, continuous 30.0 min"; without the second where it is NaN: not counted. `instant`:
/// of one moment, in the sun or not.
QString formatMinutes(float gross, float continuous, bool instant);

/// The same of the cell that holds a point; empty outside of the field.
QString formatMinutes(const ShadowField& field, glm::dvec2 point);

/// The grid cell that holds a point; none outside.
std::optional<std::size_t> cellAt(const Grid& grid, glm::dvec2 point);

}  // namespace noonmark
