#pragma once

#include "app/report/sheets/style.h"

namespace noonmark {

/// A scale bar: `parts` fields of `partM` metres each.
struct ScaleBar {
    double partM = 1;
    int parts = 2;
    [[nodiscard]] double lengthM() const { return partM * parts; }
};

/// The longest bar of a round length (1, 2 or 5 times a power of ten) that is no longer than `longestM`
/// metres (> 0).
ScaleBar scaleBarWithin(double longestM);

/// How high a scale bar with its labels and a north arrow are, in points.
constexpr double furnitureHeightPt = 30;

/// The bar with its labels in metres or kilometres, its right end at the right edge of `area`, as long as the
/// scale of `unitsPerM` makes it.
void paintScaleBar(const Canvas& canvas, const QRectF& area, const ScaleBar& bar, double unitsPerM);

/// An arrow to true north, which is up, with its letter, in the middle of `area`.
void paintNorthArrow(const Canvas& canvas, const QRectF& area);

}  // namespace noonmark
