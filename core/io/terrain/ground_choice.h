#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/city/footprints/repair_footprint.h"
#include "core/city/terrain/terrain.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

/// Interpolates every NaN cell of a row-major grid from the cells around it, weighted by their inverse
/// distance; gaps wider than 400 cells keep NaN cells in their middle. Ends early when stopped. Backend:
/// surface_model_gdal.cpp.
void fillFromAround(std::vector<float>& values, int columns, int rows, const std::stop_token& stop = {});

using BuildingList = std::vector<std::shared_ptr<const Building>>;

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
OutlineSteps measureOutlineSteps(const Terrain& terrain, const BuildingList& buildings,
                                 const std::stop_token& stop = {});

/// The ground of a surface model: posts within the outlines of buildings, or within a cell and 1 m of them,
/// and those of trees and the like (surface_model.cpp) get elevations interpolated from the posts around.
/// When stopped, the surface.
Terrain takeGroundAround(const Terrain& surface, const BuildingList& buildings,
                         const std::stop_token& stop = {});

/// The height of a part above the lowest ground under its building: the median of the surface a cell inside
/// its outline, or all of it if it is narrower; nothing beyond the surface.
std::optional<float> measureHeight(const Part& part, const Terrain& surface, float lowestGroundM);

/// A file of a city after reading.
struct GroundFile {
    std::string name;
    FilePiece* piece;       ///< its buildings may get heights
    bool isRaster = false;  ///< its terrain may be a model of the surface
};

/// The terrain of a city.
struct GroundChoice {
    std::shared_ptr<const Terrain> terrain;  ///< null: no file has one
    Warnings warnings;
};

/// Chooses the terrain: the first that shows the ground. Without one, the ground around the outlines of a
/// surface model. If the settings ask for it, buildings without a height get that of the
/// surface model, and its field is added to `heights`. Ends early when stopped.
GroundChoice chooseGround(const std::vector<GroundFile>& files, const ReadSettings& settings,
                          HeightFacts& heights, const std::stop_token& stop);

/// The outlines of equal numbers in a row-major grid, each area that is joined over sides of cells: `take`
/// gets the number and the rings, the outer one first, in columns and rows from the corner of the first cell.
/// 0 is no area. False if it fails or is stopped. Backend: surface_model_gdal.cpp.
bool outlineNumbers(std::vector<std::int32_t>& numbers, int columns, int rows,
                    const std::function<void(std::int32_t, const std::vector<RawRing>&)>& take,
                    const std::stop_token& stop);

/// What rises less above the ground is walls and cars.
inline constexpr float leastRaisedM = 2;

/// Two rasters of one place: a surface with buildings and the ground below it.
struct SurfacePair {
    const GroundFile* surface = nullptr;
    const GroundFile* ground = nullptr;
    double zeroM = 0;  ///< how far the surface lies above the ground where both show the ground
};

/// The surfaces above one ground, in the files' order; none if no file lies above another one as a surface.
/// Of several grounds that one above which a surface rises on the largest share of its posts. Error:
/// elevations that count from different zeros (more than 2 m between them) in all pairs. Looks at up to 500 x
/// 500 posts a pair.
Result<std::vector<SurfacePair>> findSurfacePairs(const std::vector<GroundFile>& files);

/// Of files without any building, rasters of which some show a surface and one the ground below them: makes
/// buildings of what rises more than 2 m above the ground on 10 m2 or more. What is joined over the
/// sides of cells is one building; its parts are prisms over cells whose elevations differ by at most twice
/// the tolerance of the settings, at the mean of the extremes. Cells without elevation and those of canopy
/// (`trees`, of a raster, whose height fits) are no buildings, nor are cells beyond the ground, or of a
/// second surface where the first has some. The surfaces' files get the buildings, and the ground is the only
/// terrain afterwards. With an extent only the buildings that touch it are made. False: there are no such
/// rasters. Error: their elevations count from different zeros, too many parts (a million), no buildings;
/// cancelled(). Some 2 us a cell.
Result<bool> makeSurfaceBuildings(const std::vector<GroundFile>& files, const std::vector<ReadTree>& trees,
                                  const ReadSettings& settings, const Frame& frame, HeightFacts& heights,
                                  Progress& progress, const std::stop_token& stop);

/// Whether a part of the building has an assumed height.
bool hasAssumedHeight(const Building& building);

/// A building whose assumed heights are replaced by `heightOf(part)` above its base; null if none is: where
/// it is nothing, or less than 1 m above the part's underside.
std::shared_ptr<const Building> withHeights(const Building& building,
                                            const std::function<std::optional<float>(const Part&)>& heightOf);

/// Gives buildings of which only the elevation of the roof is known (FilePiece::roofs) their height above the
/// terrain, and adds the fields to `heights`. Without a terrain the heights stay assumed, or count from 0 if
/// the user chose the field (`chosen`): a warning says which.
void measureRoofs(const GroundFile& file, const Terrain* terrain, const Frame& frame, bool chosen,
                  HeightFacts& heights);

/// After parts with assumed heights got others: takes back what was said of those, by part, and of the fields
/// that could hold heights if none is left.
void withdrawAssumed(const GroundFile& file);

}  // namespace noonmark
