#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Shadows on the open ground or on a plane above it at one moment, as polygons in local metres: disjoint,
/// simple and oriented, none under 0.01 m2. Ground that a building of either city covers is left out; ground
/// below an overhang is not.
struct ShadowOutlines {
    std::vector<Footprint> baseline;     ///< shadow in the baseline
    std::vector<Footprint> incremental;  ///< shadow in the scenario where the baseline is lit
    std::vector<Footprint> gained;       ///< lit in the scenario, in shadow in the baseline
    /// 0: the union of the projected buildings, exact to 1 mm. Else the outlines follow the edges of cells of
    /// this size, because the ground is not level.
    double cellM = 0;
};

struct OutlineSettings {
    Box2 area;         ///< outlines are cut at its edges, local metres; to whole cells on terrain
    double cellM = 1;  ///< of the cells on terrain, 0.25 to 10
    /// The shadows are on a horizontal plane, this many metres above the mean ground of the area, 0 to 1000;
    /// buildings below it cast none. Empty: on the ground.
    std::optional<double> planeM{};
};

/// The shadows of a baseline and of a scenario (null: the baseline alone) at a step of the sun. On level
/// ground, the buildings whose shadow can reach the area are projected and joined; on terrain, and of meshes
/// above a plane, cells are traced by the ray reference. Error: an empty area, the polygons cannot be joined,
/// errors of the ray reference and of placing its cells, or cancelled(). A square kilometre of Midtown takes
/// some 0.3 s on two cores, on level ground; of these 0.1 s join the tiles and are not interrupted.
Result<ShadowOutlines> outlineShadows(const City& baseline, const City* scenario, const SunStep& step,
                                      const OutlineSettings& settings, Progress& progress,
                                      const std::stop_token& stop);

/// The same for several steps, in their order: faster on terrain, whose scene is built once.
Result<std::vector<ShadowOutlines>> outlineShadows(const City& baseline, const City* scenario,
                                                   std::span<const SunStep> steps,
                                                   const OutlineSettings& settings, Progress& progress,
                                                   const std::stop_token& stop);

/// Square metres of all polygons together.
double area(std::span<const Footprint> polygons);

/// The shadow that a proposal would cast if it stood alone, at several moments of a day.
struct ShadowFan {
    std::vector<std::vector<Footprint>> ofStep;  ///< one list a step
    std::vector<Footprint> all;                  ///< their union
    double cellM = 0;                            ///< as in ShadowOutlines
};

/// The fan of the buildings of `proposal`, which has only those, and the terrain: their shadow on open
/// ground, whatever other buildings shade or cover there. The ground that they cover themselves is left out.
/// On terrain, ground in the terrain's own shadow is left out too. Errors as of outlineShadows().
Result<ShadowFan> outlineShadowFan(const City& proposal, std::span<const SunStep> steps,
                                   const OutlineSettings& settings, Progress& progress,
                                   const std::stop_token& stop);

/// A box around all buildings of a city and their shadows, none of them taken longer than `longestM`. Empty
/// if there is no building.
Box2 boundShadows(const City& city, std::span<const SunStep> steps, double longestM);

}  // namespace noonmark
