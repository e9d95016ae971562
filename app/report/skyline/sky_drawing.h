#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/report/skyline/sky_frame.h"
#include "core/study/point_study.h"

namespace noonmark {

/// Fill of the buildings that have one of their own.
using BuildingColours = std::map<std::uint32_t, std::string>;

/// Of overhangs, below which the sky is seen. No pattern: Qt's reader of SVG knows none.
inline constexpr const char* overhangFill = "#5b6470";
inline constexpr const char* behindWallFill = "#d5d8dc";

/// Draws one sky in one frame as SVG elements, from the bottom up.
class SkyDrawing {
public:
    SkyDrawing(const SkyFrame& frame, std::string& svg) : frame_(frame), svg_(svg) {}

    /// The empty sky with lines of altitude and azimuth.
    void drawSky();
    /// Covers the directions behind a wall that faces `facingDeg`.
    void drawBehindWall(double facingDeg);
    /// Everything below a skyline; without colours, in `fill`.
    void drawSkyline(const PointView& view, const BuildingColours& colours, const char* fill);
    void drawOverhangs(const PointView& view);
    void drawOutline(const PointView& view, const char* stroke);
    /// The sun's path of a day (index in SunSteps::days): thick where the point is lit.
    void drawPath(const SunSteps& sun, const ShadedSteps& shaded, std::size_t day, const char* colour);
    /// A dot and a number at each full hour of a day.
    void drawHours(const SunSteps& sun, std::size_t day, const Zone& zone);
    void drawLabel(double azimuthDeg, double altitudeDeg, const std::string& text, const char* anchor);

private:
    /// The points of a curve between two directions: many enough where straight lines become curves.
    void addCurve(SkylinePlace from, SkylinePlace to, std::string& points) const;
    void addPoint(double azimuthDeg, double altitudeDeg, std::string& points) const;
    void drawPolyline(const std::string& points, const char* style);

    SkyFrame frame_;
    std::string& svg_;
};

}  // namespace noonmark
