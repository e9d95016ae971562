#pragma once

#include <QImage>

#include "app/report/shadow_measure.h"
#include "core/study/study.h"

namespace noonmark {

constexpr int pictureWidth = 1600;

/// A whole sheet for the screen and for slides, pictureWidth wide: title, map, legend, scale bar, north
/// arrow, whose data it is. As high as the region's shape asks for.
QImage mapPicture(const Study& study, ShadowMeasure measure);

}  // namespace noonmark
