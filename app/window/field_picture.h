#pragma once

#include "app/report/shadow_measure.h"
#include "core/receivers/receivers.h"
#include "render/ground_picture.h"

namespace noonmark {

/// The colours of the report from no shadow to most, fine enough to be looked up.
std::vector<GroundPicture::Pixel> shadowPalette();

/// A field in the colours of the report, for the ground of the view. Cells that are no receivers are
/// transparent; but a cell under a building takes the mean colour of the receivers beside it, so that no pale
/// steps show along its walls; without `receivers` (null: of a study that still runs) it stays transparent.
/// `top` minutes have the last colour of the palette. O(cells).
GroundPicture fieldPicture(const ShadowField& field, const Receivers* receivers, ShadowMeasure measure,
                           double top);

}  // namespace noonmark
