#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/point_study.h"

namespace noonmark {

/// A city in which a point is measured: that of a scenario.
struct PointScenario {
    std::string name;
    std::shared_ptr<const City> city;  ///< not null
};

/// The same with trees.
struct PointCaseShade {
    TreeColumns column = TreeColumns::seasonal;  ///< or evergreen
    double dayMin = 0, yearMin = 0, skyView = 0, skyComponentPct = 0;
};

/// The sun and sky of the point in one city.
struct PointCaseFigures {
    std::string name;
    std::string why;                          ///< the point cannot be measured there; empty: it can
    double dayMin = 0, yearMin = 0;           ///< sunlit minutes of the question's day and year
    double skyView = 0;                       ///< 0 to 1
    double skyComponentPct = 0;               ///< of a wall
    std::vector<PointCaseShade> withTrees{};  ///< evergreens first; empty: no tree is seen
};

/// A line of a table of cases, in one column of trees.
struct PointCaseLine {
    PointCaseShade shade;  ///< or TreeColumns::without
    double changeMin = 0;  ///< sunlit minutes of the year against the first case in the same column
};
/// That without trees first, then those with trees where the point sees any in this case or in the first.
/// Neither case says why it cannot be measured.
std::vector<PointCaseLine> listCaseLines(const PointCaseFigures& figures, const PointCaseFigures& first);

/// Measures the point in each city, in their order. It must be in the same place as in the first one, else
/// `why` says so. Error: what runPointStudy() refuses in the first city, cancelled(). In Midtown 0.14 s a
/// city.
Result<std::vector<PointCaseFigures>> measurePointCases(const std::vector<PointScenario>& cases,
                                                        const PointQuestion& question,
                                                        const std::stop_token& stop);

/// The seasons in which steps that were lit are in shadow, most minutes first. The days are those of one
/// year, whose end joins its beginning.
std::vector<SeasonOfLoss> findLosses(const ShadedSteps& before, const ShadedSteps& after, const SunSteps& sun,
                                     const Zone& zone);

struct LocatedPoint {
    SkyPoint point;
    bool onRoof = false;
};

/// Where the point of a question is in a city: on the ground or the roof, or at its height. Its normal is
/// level towards `facingDeg`, or up. Error: it is inside a building or an overhang. O(parts).
Result<LocatedPoint> settlePoint(const City& city, const PointQuestion& question);

}  // namespace noonmark
