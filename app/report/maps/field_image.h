#pragma once

#include <QColor>
#include <QImage>
#include <functional>
#include <optional>

#include "app/report/maps/shadow_measure.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// A field as a picture of its grid, north up: the top left pixel begins at the grid's north-western corner.
struct FieldImage {
    QImage image;
    int cellsPerPixel = 1;  ///< along each side; the last column and row of pixels may reach beyond the grid
};

/// One pixel a cell, or the mean over the receivers of k x k cells where that still leaves `wantedPixels` on
/// the longer side. `top` minutes have the last colour of the palette. Cells that are no receivers are white;
/// but at one pixel a cell, a cell under a building takes the mean colour of the receivers that touch it, so
/// that no white steps show along the walls drawn over it. O(cells).
FieldImage makeFieldImage(const ShadowField& field, const Receivers& receivers, ShadowMeasure measure,
                          double top, int wantedPixels);

/// The same of any colours of a grid's cells; none is white. Where k x k cells share a pixel it has their
/// mean colour. O(cells).
using CellColour = std::function<std::optional<QColor>(std::size_t cell)>;
FieldImage makeColourImage(const Grid& grid, const CellColour& colour, int wantedPixels);

}  // namespace noonmark
