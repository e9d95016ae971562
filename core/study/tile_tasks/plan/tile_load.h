#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <stop_token>
#include <vector>

#include "core/city/city.h"
#include "core/engines/auto_engine.h"
#include "core/engines/common/shadow_reach.h"
#include "core/geo/grid.h"
#include "core/receivers/tile_plan.h"
#include "core/study/study.h"
#include "core/study/tile_tasks/plan/find_districts.h"

namespace noonmark {

/// The buildings and trees of a district in coarse cells: enough to tell how far a tile's occluders are, and
/// small for a whole country. A cell counts every building that touches it in `highestM` and `longestM`, and
/// those whose box has its south-west corner in it in the rest.
class OccluderSurvey {
public:
    static constexpr double defaultCellM = 200;

    struct Cell {
        static constexpr float nothing = -std::numeric_limits<float>::infinity();
        float highestM = nothing;  ///< local z of the highest point
        float longestM = 0;        ///< longest side of a building's box, widest crown
        float lowestGroundM = 0;   ///< local z; of the terrain's posts in and next to the cell
        std::uint32_t buildings = 0;
        std::uint32_t points = 0;                ///< of their footprints and meshes
        std::uint32_t overhangTriangles = 0;     ///< about
        std::array<std::uint64_t, 2> hashSum{};  ///< of the buildings and trees, in any order
    };

    /// Covers `box`; what lies outside is counted in the nearest cell.
    explicit OccluderSurvey(const Box2& box, double cellM = defaultCellM);

    /// Counts the buildings and trees of `city`; `counted`: buildings with their south-west corner in this
    /// half-open box, and trees that stand in it, are counted once and for all, other buildings only as
    /// occluders.
    void add(const City& city, const Box2& counted);
    void addTerrain(const Terrain& terrain);

    [[nodiscard]] const Grid& grid() const { return grid_; }
    [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
    [[nodiscard]] Box2 boxOf(std::size_t cell) const;
    /// The box around all counted buildings, to the last bit bounds(City).
    [[nodiscard]] const Box2& buildingsBox() const { return buildingsBox_; }

    /// The cells that touch a box, as ranges of columns and rows.
    struct Range {
        int firstColumn, endColumn, firstRow, endRow;
    };
    [[nodiscard]] Range cellsIn(const Box2& box) const;

private:
    void addTrees(const Trees& trees, const Box2& counted);

    Grid grid_;
    std::vector<Cell> cells_;
    Box2 buildingsBox_;
};

/// The surroundings that can affect a tile.
struct TileHalo {
    Box2 occluders;  ///< the tile, and every coarse cell whose highest point can shade it at some step
    /// `occluders` and all of each building that touches it, so that a reader of this box finds its buildings
    /// complete, with all their parts
    Box2 reads;
    /// Sums over the coarse cells of `reads`
    std::size_t buildings = 0;
    std::size_t points = 0;
    std::size_t overhangTriangles = 0;
    std::size_t buildingsInTile = 0;
};

/// The halo of a tile of receivers. Each cell is taken for a box as high as its highest building, so that the
/// result is never too small (ShadowReach::touches). O(cells x azimuth degrees visited).
TileHalo findHalo(const OccluderSurvey& survey, const ShadowReach& reach, const Grid& tile);

/// Estimated cost of a tile.
struct TileCost {
    double seconds = 0;      ///< on two cores like those of docs/scale.md, reading and writing included
    double memoryBytes = 0;  ///< peak of a process that runs only this tile
    double readBytes = 0;    ///< of it, for the buildings within the halo
};

/// `terrainPosts`: 0 without terrain. Within a factor of two as a rule: scheduling needs no more.
TileCost estimateTile(const TileHalo& halo, const Grid& tile, const StudySettings& settings,
                      const SunSteps& sun, std::size_t terrainPosts, const EngineList& engines);

/// The occluders in and around a district, in coarse cells.
struct SurveyedDistrict {
    OccluderSurvey survey;
    City ground;  ///< frame and terrain; no buildings
    SunSteps sun;
    std::vector<Place> places{};  ///< to be measured: all of the file that are near the district
};

/// Sets the region of a district that has none to the box around all buildings, then surveys everything whose
/// shadow can reach the region: the buildings of the request's subject, or those of its files. By window, a
/// few square kilometres are in memory at a time. Errors of
/// readers, and a sun that never rises.
Result<SurveyedDistrict> surveyDistrict(District& district, const TaskPlanRequest& request,
                                        const InputsScan& scan, Progress& progress,
                                        const std::stop_token& stop);

}  // namespace noonmark
