#pragma once

#include <QColor>
#include <optional>

#include "app/report/maps/shadow_measure.h"
#include "core/receivers/receivers.h"
#include "render/scene/ground_picture.h"

namespace noonmark {

/// An opaque pixel.
GroundPicture::Pixel pixelOf(const QColor& colour);

/// The colours of the report from no shadow to most, fine enough to be looked up.
std::vector<GroundPicture::Pixel> shadowPalette();

/// A field in the colours of the report, for the ground of the view. Cells that are no receivers are
/// transparent; but a cell under a building takes the mean colour of the receivers on the ground beside it,
/// so that no pale steps show along its walls; without `receivers` (null: of a study that still runs) it
/// stays transparent. `top` minutes have the last colour of the palette. O(cells).
GroundPicture fieldPicture(const ShadowField& field, const Receivers* receivers, ShadowMeasure measure,
                           double top);

/// The same of receivers on roofs, for the roofs of the view; cells beside a roof take its colour, so that it
/// has one up to its edges. Nothing where no receiver is on a roof.
std::optional<GroundPicture> roofPicture(const ShadowField& field, const Receivers& receivers,
                                         ShadowMeasure measure, double top);

}  // namespace noonmark
