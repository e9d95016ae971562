#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/city/trees/tree.h"
#include "core/engines/points/point_sunlight.h"
#include "core/engines/points/sky_factors.h"
#include "core/engines/points/skyline.h"
#include "core/engines/ray/tree_rays.h"

namespace noonmark {

/// The altitudes between which a crown stands at one azimuth, degrees.
struct CrownColumn {
    double azimuthDeg = 0;  ///< from true north
    double lowDeg = 0, highDeg = 0;
};

/// A crown as a point sees it.
struct SeenCrown {
    std::uint32_t tree = 0;  ///< index in City::trees
    /// From its left end to its right end, at most 5 degrees apart: ascending azimuths, of which the first is
    /// 0 to 360 and later ones may exceed 360.
    std::vector<CrownColumn> columns;
    /// Share of light that it lets through, mean over what is seen of it, in leaf and bare; of an evergreen
    /// the same.
    double leafOnTransmissivity = 0, leafOffTransmissivity = 0;
    double distanceM = 0;  ///< of its axis, in the plan
    bool inLeaf = true;    ///< on the question's day
};

/// What crowns leave of a point's sun and sky in one column. A step counts the share of the sun that they let
/// through, by the exact path through each, of suns within half a degree once.
struct PointShade {
    MonthHours minutes{};  ///< sunlit, of the year, as PointView::minutes
    double dayMin = 0;     ///< sunlit minutes of the question's day
    /// Times of the day in which buildings take nothing and crowns less than TreeShade::defaultShadedFrom, as
    /// PointView::sunlit.
    std::vector<SunBand> sunlit;
    SkyFactors sky;  ///< what is left of PointView::factors, in the mean of the days of a year
};

/// The crowns around a point, and what they leave of its sun.
struct PointCrowns {
    std::vector<SeenCrown> seen;  ///< those that rise above the skyline by half a degree, farthest first
    LeafDays leafDays;            ///< of trees that lose their leaves and state no days of their own
    bool inLeaf = false;          ///< those, on the question's day
    std::size_t weighed = 0;      ///< trees whose crown can stand before the sun on some day of the year
    PointShade evergreen, seasonal;
    static constexpr std::array columns{TreeColumns::evergreen, TreeColumns::seasonal};
    [[nodiscard]] const PointShade& of(TreeColumns column) const {
        return column == TreeColumns::evergreen ? evergreen : seasonal;
    }
    std::shared_ptr<const Trees> trees;  ///< the city's, to which indices refer
    TakenByTree takenDay, takenYear;     ///< of the sun that buildings leave, minutes
};

/// What one tree takes of a point's sun, minutes of the question's day and of the year.
struct TreeMinutes {
    std::uint32_t tree = 0;  ///< index in City::trees
    double dayEvergreen = 0, daySeasonal = 0, yearEvergreen = 0, yearSeasonal = 0;
};
/// Those that take most in the year, by their seasons, first.
std::vector<TreeMinutes> listTakenByTree(const PointCrowns& crowns);

/// The steps of one time, and at which of them the point is shaded without trees.
struct PointSteps {
    const SunSteps& sun;
    const ShadedSteps& shaded;
};

/// Towards the sun at an instant of a day; none: it is below the horizon.
using SunAt = std::function<std::optional<glm::vec3>(Instant)>;

/// None where no crown is seen or weighed. `sky`: of the skyline. `northDeg`: true north, clockwise from the
/// frame's +y. `year`: from sunrise to sunset; `day`: those of the question's day, and `sunAt` of that day.
/// O(trees), and some 20 us for each crown that is seen; 10 ns for each crown near the azimuth of each half
/// degree of the sun's paths.
std::optional<PointCrowns> lookAtCrowns(const City& city, const SkyPoint& point, const Skyline& skyline,
                                        const SkyFactors& sky, double northDeg, const PointSteps& year,
                                        const PointSteps& day, const SunAt& sunAt, const Zone& zone);

}  // namespace noonmark
