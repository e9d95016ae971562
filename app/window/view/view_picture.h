#pragma once

#include <QImage>
#include <optional>

#include "app/report/maps/legend_painter.h"

namespace noonmark {

/// What stands around a picture of the view.
struct PictureFrame {
    QString title;                 ///< project and what is shown
    QString when;                  ///< date and hours
    std::optional<Legend> legend;  ///< none: no colours are shown
    QString note;                  ///< what is shown of the whole, or what to beware of; wrapped, not cut
    QString credit;                ///< the owner of the data
    double pixelsPerM = 1;         ///< of the view's picture, on the ground in its middle
    bool fromAbove = false;        ///< then the scale is the same everywhere
    double headingDeg = 0;         ///< azimuth of the view, clockwise from north
};

/// A picture to keep: title and time above the view; legend, scale bar, north arrow, note and credit below.
QImage viewPicture(const QImage& view, const PictureFrame& frame);

}  // namespace noonmark
