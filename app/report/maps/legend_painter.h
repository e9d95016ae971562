#pragma once

#include <QImage>
#include <QLocale>
#include <QString>

#include "app/report/maps/shadow_measure.h"
#include "app/report/maps/style.h"
#include "core/measures/colour_scale.h"

namespace noonmark {

/// A colour outside the scale, with its label.
struct LegendPatch {
    QColor colour;
    QString label;
};

/// What a legend states beside its unit.
struct LegendNote {
    QString text;      ///< NM_TEXT: "largest %1"
    QString number{};  ///< stands for %1
};

/// A legend: maps colours back to minutes. Title, unit and the labels of classes and patches are English and
/// marked by NM_TEXT; the GUI translates them.
struct Legend {
    QString title;                       ///< "Gross shadow"
    QString unit;                        ///< "minutes in shadow a day"
    LegendScale scale;                   ///< colours run from 0 to scale.top
    bool instant = false;                ///< two patches, sunlit and shaded, instead of a scale
    bool change = false;                 ///< signed scale from -scale.top to scale.top
    std::vector<LegendPatch> patches{};  ///< colours outside the scale
    std::vector<LegendPatch> classes{};  ///< if any: patches in their order instead of a scale
    /// The colours from colours->low to colours->high; none: those of plainScale().
    std::optional<ColourScale> colours{};
    std::vector<LegendNote> notes{};
    QLocale numbers = QLocale::c();  ///< that writes the labels of the scale
};

/// "min a day, scale fitted to this difference, largest 12"
QString describeUnit(const Legend& legend);

/// What a map of the measure shows: continuous shadow is always minutes of shadow.
ShownQuantity quantityOf(ShadowMeasure measure, ShownAs show, double sunlitMin);

/// The legend of minutes up to `topMin`, in the choice's colours; `minutes` are those of the map's cells.
/// O(cells log cells) with quantiles.
Legend makeLegend(ShadowMeasure measure, const LegendChoice& choice, double sunlitMin, double topMin,
                  std::span<const float> minutes);

/// The legend of a map of `measure`. O(cells). A moment's has two patches.
Legend makeLegend(const ShadowField& field, ShadowMeasure measure, const LegendChoice& choice = {});

/// Adds which shadow the map shows: "without trees", "trees as evergreens", "trees with their seasons".
void nameTrees(Legend& legend, TreeColumns trees);

/// The legend of a map of that column of the field that the choice names (fieldOfColumn()), which it names
/// where the field has any with trees.
Legend makeColumnLegend(const ShadowField& field, ShadowMeasure measure, const LegendChoice& choice);

/// Two patches: sun and shadow.
Legend momentLegend();

/// The colours of a map with this legend; of a moment those of sun and shadow.
ColourScale coloursOf(const Legend& legend);
std::optional<QColor> pickColour(const ColourScale& scale, double minutes);  ///< as ColourScale::pick()

/// Height of a legend, points.
constexpr double legendHeightPt = 36;

/// Paints title with unit, colour bar and ticks from the top left corner of `area`, as wide as `area` and
/// legendHeightPt high. Labels stay within the width; where they would touch, only every second, third...
/// label appears.
void paintLegend(const Canvas& canvas, const QRectF& area, const Legend& legend);

}  // namespace noonmark
