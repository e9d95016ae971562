#pragma once

// The folder app/report/skyline draws what a point sees of the sky. This file declares the drawing
// (skyline_svg.cpp) and its parts (sky_drawing.cpp): directions on it, the sky in one of its two frames, and
// the sunlit minutes by month and hour.

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/study/point_study.h"

namespace noonmark {

/// Where a direction of the sky lies on a drawing, y down. Azimuths are from true north, clockwise, degrees;
/// altitudes 0 to 90.
struct SkyFrame {
    enum class Kind { cylindrical, stereographic };
    Kind kind = Kind::cylindrical;
    glm::dvec2 corner{};  ///< cylindrical: azimuth 0 at the horizon; stereographic: the zenith
    double widthPx = 1;   ///< cylindrical: of 360 degrees
    double heightPx = 1;  ///< cylindrical: of 90 degrees; stereographic: radius of the horizon

    [[nodiscard]] glm::dvec2 at(double azimuthDeg, double altitudeDeg) const {
        if (kind == Kind::cylindrical)
            return corner + glm::dvec2(azimuthDeg / 360 * widthPx, -altitudeDeg / 90 * heightPx);
        const double azimuth = azimuthDeg * std::numbers::pi / 180;
        const double radius = heightPx * std::tan((90 - altitudeDeg) * std::numbers::pi / 360);
        return corner + radius * glm::dvec2(std::sin(azimuth), -std::cos(azimuth));
    }
};

/// Fill of the buildings that have one of their own.
using BuildingColours = std::map<std::uint32_t, std::string>;

/// The colour of overhangs, below which the sky is seen. No pattern: Qt's reader of SVG knows none.
inline constexpr const char* overhangFill = "#5b6470";
inline constexpr const char* behindWallFill = "#d5d8dc";
inline constexpr const char* crownFill = "#3f7d3a";

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
    /// Each crown as dense as it is on the day, so that several let through what they do together.
    void drawCrowns(const PointCrowns& crowns);
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

/// The sunlit minutes of a point's year in a column of trees; where it sees none, those without.
const MonthHours& minutesOf(const PointView& view, TreeColumns trees);

/// Adds to `svg` the sunlit minutes of a mean day by month (rows, January first) and hour of the wall clock
/// (columns): the more, the darker. Beside each figure, in red or green, the minutes that the scenario takes
/// or gives, from half a minute on. `corner`: the upper left of the cells; labels lie outside, 40 px to the
/// left and 14 px above.
void drawSunCarpet(const PointStudy& study, TreeColumns trees, glm::dvec2 corner, std::string& svg);

/// The width of the drawing, and the height of its upper part, the cylindrical frame.
inline constexpr int skylineSvgWidthPx = 1200, skylineSvgUpperPx = 450;

/// The skyline of a point as SVG, in a cylindrical frame (azimuth across, altitude up) and a stereographic
/// one (the sky from above: north up, east to the right, the zenith in the middle). Buildings that hide most
/// have colours of their own, listed with the azimuths that each takes; the others are grey, overhangs
/// dark; crowns are green, as dense as on the day that was asked for. The sun's paths of the 21st of December
/// to June, thick where the point is lit, with full hours of `zone`, and the path of the day that was asked
/// for. What a scenario hides beyond the baseline is red. Below, the sunlit minutes of a mean day by month
/// and hour; where trees are seen, again with trees as evergreens and with their seasons. `city`: the
/// baseline, which names buildings.
std::string skylineSvg(const PointStudy& study, const City& city, const Zone& zone);

}  // namespace noonmark
