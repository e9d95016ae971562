#pragma once

#include <QImage>
#include <optional>

#include "app/report/maps/legend_painter.h"

namespace noonmark {

/// Title, legend and other texts around a picture of the view.
struct PictureFrame {
    QString title;                         ///< project and displayed result
    QString when;                          ///< date and hours
    std::optional<Legend> legend;          ///< none: no colours are shown
    std::vector<LegendPatch> buildings{};  ///< what colours of buildings mean that are no result
    /// How complete or exact the result is; wrapped, not cut.
    QString note;
    QString credit;          ///< the owner of the data
    double pixelsPerM = 1;   ///< scale on the ground in the middle of the view
    bool fromAbove = false;  ///< a top view: the scale is the same everywhere
    double headingDeg = 0;   ///< azimuth of the view, clockwise from north
};

/// The complete picture: title and time above the view; legend, scale bar, north arrow, note and credit
/// below. `scale`: of texts and margins.
QImage viewPicture(const QImage& view, const PictureFrame& frame, double scale = 1);
/// The height that these take of a picture of this width.
int heightOfFrame(int width, const PictureFrame& frame, double scale = 1);

}  // namespace noonmark
