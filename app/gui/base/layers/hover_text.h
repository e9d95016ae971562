#pragma once

#include <QString>
#include <optional>

#include "core/engines/api/shadow_field.h"
#include "core/measures/shown_quantity.h"
#include "render/view/scene_picker.h"

namespace noonmark {

/// Describes what is under the cursor, for the status bar: position in degrees and local metres, the building
/// with its height, and `minutes` of shadow there, if known.
QString hoverText(const Pick& pick, const City& city, const QString& minutes);

/// "gross 60.0 min a day, continuous 30.0 min"; without the second if it is NaN (not computed). `instant`: of
/// one moment, "in the sun" or "in shadow".
QString formatMinutes(float gross, float continuous, bool instant);

/// The same for the cell that contains a point; empty outside the field. As sun: "4.3 h of sun a day (65.0 %
/// of the sunlit time)", with continuous shadow as it is.
QString formatMinutes(const ShadowField& field, glm::dvec2 point, ShownAs show = ShownAs::shadow);
QString formatShown(float gross, float continuous, const ShownQuantity& quantity);

/// The grid cell that contains a point; nothing outside.
std::optional<std::size_t> cellAt(const Grid& grid, glm::dvec2 point);

}  // namespace noonmark
