#pragma once

#include <QImage>
#include <QString>

#include "app/report/maps/palette.h"
#include "app/report/maps/shadow_measure.h"
#include "app/report/sheets/style.h"

namespace noonmark {

/// A colour that is no place on the scale.
struct LegendPatch {
    QColor colour;
    QString label;
};

/// What a reader needs to turn a colour back into minutes.
struct Legend {
    QString title;         ///< "Gross shadow"
    QString unit;          ///< "minutes in shadow a day"
    LegendScale scale;     ///< colours run from 0 to scale.top
    bool instant = false;  ///< two patches, in the sun and in shadow, instead of a scale
    bool change = false;   ///< less and more shadow: impactColour(value / scale.top), from -top to top
    std::vector<LegendPatch> patches{};  ///< what has a colour of its own
    bool wanted = false;                 ///< with `change`: more is wanted, impactColour(-value / scale.top)
};

/// The legend of a map of `measure`. O(cells). Colour a value with shadowColour(value / legend.scale.top).
Legend makeLegend(const ShadowField& field, ShadowMeasure measure);

/// How high a legend is, in points.
constexpr double legendHeightPt = 36;

/// Title with unit, colour bar and ticks from the top left corner of `area`, as wide as `area` and
/// legendHeightPt high. Labels stay within the width; where they would touch each other, only every second,
/// third... is written.
void paintLegend(const Canvas& canvas, const QRectF& area, const Legend& legend);

}  // namespace noonmark
