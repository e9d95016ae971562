#pragma once

// The folder app/gui/docks/places shows how much sun places get. SunScale has the colours, PlaceSunModel is
// the table, PlacesDock both with a threshold, and PlaceLinks connects them with the workbench and the view.

#include <QColor>

#include "app/report/maps/legend_painter.h"

namespace noonmark {

/// Colours of places in classes that colour-blind readers can tell apart: violet below the threshold, orange
/// from it on; the more sun, the lighter. Of a change: those of all maps of change.
class SunScale {
public:
    SunScale() = default;
    /// Of hours of sun a day, up to `topHours`.
    static SunScale ofHours(double thresholdHours, double topHours);
    static SunScale ofChange();  ///< hours of sun a day, negative: less

    [[nodiscard]] QColor colourOf(double hours) const;  ///< NaN: grey
    [[nodiscard]] const Legend& legend() const { return legend_; }

private:
    void add(double from, double to, const QColor& colour, const QString& label);

    struct Class {
        double to = 0;  ///< excluded
        QColor colour;
    };
    std::vector<Class> classes_;  ///< ascending
    Legend legend_;
};

}  // namespace noonmark
