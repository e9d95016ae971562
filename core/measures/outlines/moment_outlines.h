#pragma once

// The folder core/measures/outlines makes polygons of shadows. This file projects buildings onto level
// ground and joins their polygons to the outlines of a moment, for all buildings near an area; on terrain it
// makes the outlines of traced cells. shadow_outlines.h puts the moments of a day into one picture,
// day_isochrones.h draws lines of equal values.

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/city/footprints/footprint.h"
#include "core/measures/shadow_outlines.h"

namespace noonmark {

/// Convex, counter-clockwise, local metres, not closed.
using ConvexPolygon = std::vector<glm::dvec2>;

/// Adds polygons that together are the shadow of a building on level ground at z = 0, except where the
/// building itself covers the ground. `perMetre`: where the shadow of a point 1 m up falls, seen from the
/// point below it. What lies below the ground casts none. O(points), and a triangulation for each concave
/// overhang.
void projectBuilding(const Building& building, glm::dvec2 perMetre, std::vector<ConvexPolygon>& to);

/// The part of a convex polygon in a box; empty if there is none. Points on a side of the box lie on it
/// exactly.
ConvexPolygon clipToBox(const ConvexPolygon& polygon, const Box2& box);

/// Leaves out the polygons that lie in another one of the list, so that fewer have to be joined. Largest
/// first. O(polygons x polygons left).
void dropContained(std::vector<ConvexPolygon>& polygons);

/// The projected polygons of one moment. They may overlap and reach beyond the area.
struct ProjectedShadowPolygons {
    std::vector<ConvexPolygon> common;    ///< of buildings that the baseline and the scenario share
    std::vector<ConvexPolygon> baseline;  ///< of those of the baseline alone
    std::vector<ConvexPolygon> scenario;  ///< of those of the scenario alone
};

/// Joins them to outlines, cut at the edges of `area`, without the ground in `cover`. Works in tiles on all
/// cores. Error: the polygons cannot be joined even on a grid of 1 mm, or cancelled(). Backend:
/// moment_outlines_geos.cpp.
Result<ShadowOutlines> joinShadows(const ProjectedShadowPolygons& polygons,
                                   const std::vector<Footprint>& cover, const Box2& area, Progress& progress,
                                   const std::stop_token& stop);

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

/// As outlineShadows(), for any ground: cells that are ground in both cities are traced by the ray reference,
/// and the outlines run along their edges. Cost: that of the ray reference, and O(cells).
Result<std::vector<ShadowOutlines>> traceOutlines(const City& baseline, const City* scenario,
                                                  std::span<const SunStep> steps,
                                                  const OutlineSettings& settings, Progress& progress,
                                                  const std::stop_token& stop);

}  // namespace noonmark
