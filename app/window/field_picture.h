#pragma once

#include "app/report/shadow_measure.h"
#include "core/receivers/receivers.h"
#include "render/ground_picture.h"

namespace noonmark {

/// A field in the colours of the report, for the ground of the view. Cells that are no receivers are
/// transparent; but a cell under a building takes the mean colour of the receivers beside it, so that no pale
/// steps show along its walls. `top` minutes have the last colour of the palette. O(cells).
GroundPicture fieldPicture(const ShadowField& field, const Receivers& receivers, ShadowMeasure measure,
                           double top);

}  // namespace noonmark
