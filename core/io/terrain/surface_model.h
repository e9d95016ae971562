#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/city/building.h"
#include "core/city/terrain/terrain.h"

namespace noonmark {

/// Interpolates every NaN cell of a row-major grid from the cells around it, weighted by their inverse
/// distance; gaps wider than 400 cells keep NaN cells in their middle. Ends early when stopped. Backend:
/// surface_model_gdal.cpp.
void fillFromAround(std::vector<float>& values, int columns, int rows, const std::stop_token& stop = {});

using SharedBuildings = std::vector<std::shared_ptr<const Building>>;

/// How a terrain steps at the outlines of buildings: the median over an outline of the elevation a cell and a
/// half inside minus that outside, where no other building stands. A slope rises on one side as it falls on
/// the other, so that only a roof in the terrain gives a step.
struct OutlineSteps {
    std::size_t buildings = 0;  ///< that are wide enough for the terrain's cells, at most 10 m wide
    std::size_t stepped = 0;    ///< by more than 1.5 m, and by more than 0.4 of their height if it is known
    double medianM = 0;         ///< of the steps of these
    /// Whether the terrain shows roofs: at more than half of the outlines.
    [[nodiscard]] bool showsBuildings() const { return 2 * stepped > buildings; }
};

/// `buildings`: their z need not be that of the terrain. On all cores. When stopped, without meaning.
OutlineSteps measureOutlineSteps(const Terrain& terrain, const SharedBuildings& buildings,
                                 const std::stop_token& stop = {});

/// The ground of a surface model: posts within the outlines of buildings, or within a cell and 1 m of them,
/// and those of trees and the like (surface_model.cpp) get elevations interpolated from the posts around.
/// When stopped, the surface.
Terrain takeGroundAround(const Terrain& surface, const SharedBuildings& buildings,
                         const std::stop_token& stop = {});

/// The height of a part above the lowest ground under its building: the median of the surface a cell inside
/// its outline, or all of it if it is narrower; nothing beyond the surface.
std::optional<float> measureHeight(const Part& part, const Terrain& surface, float lowestGroundM);

}  // namespace noonmark
