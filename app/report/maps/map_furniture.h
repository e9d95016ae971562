#pragma once

#include "app/report/maps/style.h"
#include "core/base/display_units.h"

namespace noonmark {

/// A scale bar of `parts` fields of `partM` metres each.
struct ScaleBar {
    double partM = 1;
    int parts = 2;
    bool inFeet = false;  ///< labelled in feet or miles, not in metres or kilometres
    [[nodiscard]] double lengthM() const { return partM * parts; }
};

/// The longest bar of a round length (1, 2 or 5 times a power of ten) of at most `longestM` metres (> 0): in
/// feet for imperial units, or in miles from one on; in metres for the others.
ScaleBar scaleBarWithin(double longestM, UnitSystem units = UnitSystem::metric);

/// Height of a labelled scale bar or a north arrow, points.
constexpr double furnitureHeightPt = 30;

/// Paints the bar with its labels at a scale of `unitsPerM`; its right end touches
/// the right edge of `area`.
void paintScaleBar(const Canvas& canvas, const QRectF& area, const ScaleBar& bar, double unitsPerM);

/// Paints an arrow with its letter in the centre of `area`; true north is up.
void paintNorthArrow(const Canvas& canvas, const QRectF& area);

}  // namespace noonmark
