#pragma once

// The folder core/receivers says where shadow is measured. Region is the area of a study;
// Receivers (this file) are the cells of a grid over it, on the ground or on roofs (roof_receivers.h);
// SurfacePoints (point_receivers.h) are points on any surface. rasterize.h turns polygons into cells,
// tile_plan.h divides a large grid into tiles.

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/city/footprints/footprint.h"
#include "core/geo/frame.h"
#include "core/geo/grid.h"

namespace noonmark {

/// The area of a study: one or more polygons in local metres.
struct Region {
    std::string name;
    std::vector<Footprint> polygons;
    bool operator==(const Region&) const = default;
};

/// The longitude/latitude box west, south, east, north (degrees) as a polygon in local metres; its sides
/// follow the curves of the projection. Across the antimeridian west is the larger number:
/// 179.9,-16.9,-179.9,-16.7. Error if the box is empty, more than 180 degrees wide, or a value is out of
/// range.
Result<Region> makeRegionFromLonLatBox(const Frame& frame, double westDeg, double southDeg, double eastDeg,
                                       double northDeg);

Region makeRegionFromLocalBox(const Box2& box);

Box2 bounds(const Region& region);
double area(const Region& region);  ///< m2

enum class CellKind : std::uint8_t {
    outside,   ///< its centre is not in the region, or no shadow is measured there
    building,  ///< its centre is where a part touches the ground (core/city/terrain/building_ground.h)
    ground,    ///< a receiver
    roof,      ///< a receiver on top of a building
    water,     ///< its centre is on water of the city's map, and in no building: no receiver
};
inline bool isReceiver(CellKind kind) { return kind == CellKind::ground || kind == CellKind::roof; }

/// The cells of a regular grid where shadow is measured, on the ground or on roofs.
struct Receivers {
    Grid grid;
    std::vector<CellKind> kind;        ///< grid order
    std::vector<float> groundM;        ///< grid order, local z of the ground or roof; empty: flat at z = 0
    std::vector<std::uint32_t> cells;  ///< indices of the receivers, ascending
    /// How much of each of `cells` counts where shadow is summed over areas by building, 0 to 9: a cell on
    /// the edge of a place counts by its share. Empty: all of each. Minutes of cells do not depend on it.
    std::vector<double> shares{};
    [[nodiscard]] glm::vec3 position(std::uint32_t cell) const;
    [[nodiscard]] bool flat() const { return groundM.empty(); }
};

/// What cells on water are (areas of ContextKind::water in City::context): no receivers, as in every study of
/// a region, or ground, as for places, which are measured whole, and for outlines, as shadow falls on water
/// too.
enum class WaterCells { leftOut, ground };

/// The surfaces where shadow is measured.
enum class ReceiverPlaces { ground, roofs, both };

struct ReceiverSettings {
    static constexpr double minCellM = 0.25;
    static constexpr double maxCellM = 10;
    double cellM = 1;  ///< cell size, metres, 0.25 to 10
    ReceiverPlaces places = ReceiverPlaces::ground;
    bool operator==(const ReceiverSettings&) const = default;
};

/// Local z of the lowest receiver; 0 if there are none.
double lowestGroundM(const Receivers& receivers);

/// Classifies the cells of the region's bounding box. West and south edges lie on multiples of the cell size,
/// so that overlapping regions have the same cells. Always on the ground, whatever `settings.places` says
/// (for roofs see core/receivers/roof_receivers.h). Memory 9 bytes per cell; refused above 2^31 cells.
/// cancelled() when stopped.
Result<Receivers> placeReceiversOnGround(const City& city, const Region& region,
                                         const ReceiverSettings& settings, const std::stop_token& stop = {});

/// The grid of these receivers, which covers the region's box. The same errors.
Result<Grid> gridOver(const Region& region, const ReceiverSettings& settings);

/// The cells of any part of that grid, identical to those of the whole. O(cells of the part + buildings +
/// areas of the map). cancelled() when stopped.
Result<Receivers> placeReceiversInPart(const City& city, const Region& region, const Grid& part,
                                       const std::stop_token& stop = {},
                                       WaterCells water = WaterCells::leftOut);

}  // namespace noonmark
