#pragma once

// The folder app/report/skyline draws what a point sees of the sky. skyline_svg.h (this file) makes the
// drawing, sky_drawing.h places directions on it and draws the sky in one of its two frames and the sunlit
// minutes by month and hour.

#include <string>

#include "core/city/city.h"
#include "core/study/point_study.h"

namespace noonmark {

/// The width of the drawing, and the height of its upper part, the cylindrical frame.
inline constexpr int skylineSvgWidthPx = 1200, skylineSvgUpperPx = 450;

/// The skyline of a point as SVG, in a cylindrical frame (azimuth across, altitude up) and a stereographic
/// one (the sky from above: north up, east to the right, the zenith in the middle). Buildings that hide most
/// have colours of their own, listed with the azimuths that each takes; the others are grey, overhangs
/// dark. The sun's paths of the 21st of December to June, thick where the point is lit, with full hours of
/// `zone`, and the path of the day that was asked for. What a scenario hides beyond the baseline is red.
/// Below, the sunlit minutes of a mean day by month and hour. `city`: the baseline, which names buildings.
std::string skylineSvg(const PointStudy& study, const City& city, const Zone& zone);

}  // namespace noonmark
