#pragma once

#include <QColor>
#include <optional>

#include "app/report/maps/shadow_measure.h"
#include "core/measures/colour_scale.h"
#include "core/receivers/receivers.h"
#include "render/scene/ground_picture.h"

namespace noonmark {

/// An opaque pixel.
GroundPicture::Pixel pixelOf(const QColor& colour);

/// The colours of 0 to `topMin` minutes, in steps fine enough for a lookup table.
std::vector<GroundPicture::Pixel> paletteOf(const ColourScale& scale, double topMin);

/// A field in the colours of its legend, for the ground of the view. Cells that are not receivers and those
/// that the scale leaves free are transparent.
/// However, a cell under a building gets the mean colour of the adjacent ground receivers, so that no pale
/// steps show along the walls; without `receivers` (null: of a running study) it stays transparent.
/// O(cells).
GroundPicture fieldPicture(const ShadowField& field, const Receivers* receivers, ShadowMeasure measure,
                           const ColourScale& scale);

/// The same for receivers on roofs. Cells beside a roof get its colour, so that the colour reaches the roof's
/// edges. Nothing if no receiver is on a roof.
std::optional<GroundPicture> roofPicture(const ShadowField& field, const Receivers& receivers,
                                         ShadowMeasure measure, const ColourScale& scale);

}  // namespace noonmark
