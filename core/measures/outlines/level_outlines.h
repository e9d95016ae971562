#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/measures/outlines/projected_polygons.h"
#include "core/measures/shadow_outlines.h"

namespace noonmark {

/// Outlines of shadows on level ground, for several moments of the same cities. They must outlive it. The
/// terrain of a city is ignored.
class LevelOutliner {
public:
    /// `scenario` may be null. O(buildings log buildings).
    LevelOutliner(const City& baseline, const City* scenario, const Box2& area);

    /// As outlineShadows(). One step at a time uses all cores.
    [[nodiscard]] Result<ShadowOutlines> outline(const SunStep& step, Progress& progress,
                                                 const std::stop_token& stop) const;

private:
    /// Some of a city's buildings.
    struct Group {
        std::vector<const Building*> buildings;
        std::vector<Box2> boxes;
        std::vector<float> heightsM;
    };
    [[nodiscard]] static Group groupOf(const City& city, const std::vector<std::uint32_t>& indices);
    [[nodiscard]] std::vector<ConvexPolygon> project(const Group& group, const SunStep& step,
                                                     const std::stop_token& stop) const;

    Box2 area_;
    Group common_, baseline_, scenario_;
    std::vector<Footprint> cover_;  ///< ground in the area that a building of either city covers
};

}  // namespace noonmark
