#pragma once

#include <QColor>
#include <QImage>
#include <functional>
#include <optional>

#include "app/report/maps/shadow_measure.h"
#include "core/measures/colour_scale.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// A field as a picture of its grid, north up: the top left pixel lies at the grid's north-western corner.
struct FieldImage {
    QImage image;
    int cellsPerPixel = 1;  ///< per side; the last column and row of pixels may extend beyond the grid
};

/// One pixel per cell, or per k x k cells their mean over the receivers where at least `wantedPixels` remain
/// on the longer side. Cells that are not receivers and those that the scale leaves free are
/// white, except that at one pixel per cell a cell under a building takes the mean colour of adjacent
/// receivers, so that no white steps appear along its walls. O(cells).
FieldImage makeFieldImage(const ShadowField& field, const Receivers& receivers, ShadowMeasure measure,
                          const ColourScale& scale, int wantedPixels);

/// The same for arbitrary colours of the grid's cells; empty is white. Where k x k cells share a pixel it has
/// their mean colour. O(cells).
using CellColour = std::function<std::optional<QColor>(std::size_t cell)>;
FieldImage makeColourImage(const Grid& grid, const CellColour& colour, int wantedPixels);

}  // namespace noonmark
