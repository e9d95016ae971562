#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/describe/text.h"
#include "core/engines/common/run_counter.h"
#include "core/engines/points/point_sunlight.h"
#include "core/engines/ray/surface_rays.h"
#include "core/engines/trees/crowns.h"
#include "core/engines/trees/crowns_around.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

/// What one point has with trees of one column.
struct PointColumn {
    std::array<double, 12> taken{};  // steps by month, weighted by what is taken from the sun
    RunCounter shadow, sun;

    void add(bool isShaded, double share, std::size_t month, std::uint32_t starts, double shadedFrom) {
        if (!isShaded) taken[month] += share;
        const std::uint32_t dark = isShaded || share >= shadedFrom ? 1 : 0;
        shadow.add(dark, starts, 1);
        sun.add(1 - dark, starts, 1);
    }
};

class PointShading {
public:
    PointShading(const ShadedStepFinder& finder, const CrownScene& crowns, const SurfacePoints& points,
                 const SunSteps& sun, ShadedPoints& made)
        : finder_(finder), crowns_(crowns), points_(points), sun_(sun), patches_(sun), made_(made) {}

    void run(Progress& progress, const std::stop_token& stop) const {
        std::atomic<std::size_t> done{0};
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points_.size(), 16), [&](const auto& range) {
            const FlushDenormals flush;
            CrownsOverPoint crowns(crowns_.crowns, patches_, crowns_.phases);
            for (std::size_t i = range.begin(); i < range.end() && !stop.stop_requested(); ++i)
                shade(i, crowns);
            progress.report(double(done += range.size()) / double(points_.size()),
                            NM_TEXT("weighing crowns at points"));
        });
    }

private:
    void shade(std::size_t point, CrownsOverPoint& crowns) const {
        const SkyPoint at{points_.positions[point], points_.normals[point]};
        if (!crowns.begin(glm::dvec3(placeSurfaceRayOrigin(at.position, at.normal)))) return;
        const ShadedSteps shaded = finder_.find(at);
        PointColumn evergreen, seasonal;
        for (const SunDay& day : sun_.days) addDay(day, shaded, crowns, evergreen, seasonal);
        write(evergreen, point, *made_.evergreen);
        write(seasonal, point, *made_.seasonal);
    }

    void addDay(const SunDay& day, const ShadedSteps& shaded, CrownsOverPoint& crowns, PointColumn& evergreen,
                PointColumn& seasonal) const {
        const auto month = std::size_t(unsigned(day.date.month()) - 1);
        std::int32_t slotBefore = -2;
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i) {
            const std::uint32_t starts = sun_.steps[i].slot == slotBefore + 1 ? 0 : 1;
            slotBefore = sun_.steps[i].slot;
            const bool isShaded = shaded[i] != 0;
            const auto depth = isShaded ? CrownsOverPoint::Depth{0, 0} : crowns.at(i);
            const double season = crowns_.inLeaf[i] != 0 ? depth.inLeaf : depth.bare;
            evergreen.add(isShaded, -std::expm1(-depth.inLeaf), month, starts, made_.shadedFrom);
            seasonal.add(isShaded, -std::expm1(-season), month, starts, made_.shadedFrom);
        }
    }

    // The minutes without trees are those of the sweep, which may be off by a few of those found here.
    void write(const PointColumn& column, std::size_t point, PointMonths& months) const {
        for (std::size_t month = 0; month < 12; ++month) {
            float& sunlit = months.sunlitMin[point][month];
            sunlit = std::max(0.0F, sunlit - float(column.taken[month] * sun_.stepMinutes));
        }
        if (months.longestShadowMin.empty()) return;
        months.longestShadowMin[point] = float(column.shadow.longest() * sun_.stepMinutes);
        months.longestSunMin[point] = float(column.sun.longest() * sun_.stepMinutes);
    }

    const ShadedStepFinder& finder_;
    const CrownScene& crowns_;
    const SurfacePoints& points_;
    const SunSteps& sun_;
    const SunPatches patches_;
    ShadedPoints& made_;
};

PointMonths copyMonths(const PointMonths& without) {
    PointMonths months = without;
    months.cost = {};
    return months;
}

}  // namespace

Result<std::optional<ShadedPoints>> shadeTreesAtPoints(const City& city, const SurfacePoints& points,
                                                       const SunSteps& sun, const PointMonths& without,
                                                       TreeColumns columns, ShadedStepFinder::By by,
                                                       Progress& progress, const std::stop_token& stop) {
    if (!city.trees || columns == TreeColumns::without) return std::nullopt;
    const CrownScene crowns = findCrowns(city, points, sun);
    if (crowns.empty()) return std::nullopt;
    const auto finder = ShadedStepFinder::over(city, sun, by, stop);
    if (!finder) return tl::make_unexpected(finder.error());
    ShadedPoints made{copyMonths(without), copyMonths(without)};
    made.treesUsed = crowns.crowns.size();
    made.how = "the exact length of the path through each crown, by half degrees of the sun";
    PointShading(*finder, crowns, points, sun, made).run(progress, stop);
    if (stop.stop_requested()) return cancelled();
    if (columns == TreeColumns::evergreen) made.seasonal.reset();
    if (columns == TreeColumns::seasonal) made.evergreen.reset();
    return made;
}

}  // namespace noonmark
