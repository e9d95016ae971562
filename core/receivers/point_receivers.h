#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/city/building_heights.h"
#include "core/city/city.h"
#include "core/receivers/points/glazing_pane.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Receiver points on any surface: ground, roofs, facades, terrain. Two arrays of the same size; neighbours
/// in the arrays should be neighbours in space, or engines are slower.
struct SurfacePoints {
    std::vector<glm::vec3> positions;  ///< local metres, on the surface
    std::vector<glm::vec3> normals;    ///< unit vectors, outward from the surface
    /// Position of the viewer. Engines that rasterise give more of their resolution to the surroundings of
    /// this position; without it, all points get the same.
    std::optional<glm::vec3> eye;

    [[nodiscard]] std::size_t size() const { return positions.size(); }
};

/// What a point receiver belongs to.
enum class ElementKind : std::uint8_t { facade, window, plane, point };
/// "facade", "window", "plane", "point"
std::string_view nameOf(ElementKind kind);

/// Where a point receiver belongs.
struct PointElement {
    static constexpr std::uint32_t noBuilding = 0xFFFFFFFF;
    std::string id;  ///< unique among the receivers: "way 34633854 wall 2 floor 0 bay 3"
    ElementKind kind = ElementKind::point;
    std::uint32_t building = noBuilding;  ///< index in City::buildings
    std::int32_t floor = 0;               ///< storey, counted from the building's lowest wall
    bool operator==(const PointElement&) const = default;
};

/// Single points where sunlight is measured. Lists of the same size, in the same order.
struct PointReceivers {
    SurfacePoints points;
    std::vector<PointElement> elements;
    /// The rectangle that a point stands for, about the point: a bay of a storey, a window, a cell.
    std::vector<PaneSize> panes;
    [[nodiscard]] std::size_t size() const { return elements.size(); }
};

/// Receivers on walls: one for each storey and bay.
struct FacadeSettings {
    static constexpr double minM = 0.25, maxM = 50;  ///< of a bay and of a storey
    double bayM = 3;                  ///< width of a bay: a wall has as many equal bays as come nearest to it
    double storeyM = defaultStoreyM;  ///< height of a storey, of buildings that state none (OwnStoreys)
    double aboveFloorM = 1.5;  ///< height of the receivers above the floor of their storey, 0 to storeyM
    bool operator==(const FacadeSettings&) const = default;
};

/// Heights of storeys, metres, of buildings that state them, as designed towers do; by Building::sourceId.
using OwnStoreys = std::map<std::string, double, std::less<>>;

/// The height of the storeys of a building's facades: its own, or that of the settings.
double findStoreyM(const Building& building, const FacadeSettings& settings, const OwnStoreys& own);

/// Receivers on the outside of all walls of these buildings, in the middle of each bay. Storeys are counted
/// from the building's lowest wall. There are none where the wall touches another part or building (5 cm in
/// front of it is solid), nor where the ground covers it. Walls of meshes are their faces within 6 degrees of
/// vertical; faces of one plane make one wall. Error: a setting out of range, an index that does not exist,
/// more than `maxReceivers`, cancelled(). Some 1 us a receiver.
Result<PointReceivers> placeOnFacades(const City& city, std::span<const std::uint32_t> buildings,
                                      const FacadeSettings& settings, const std::stop_token& stop = {},
                                      const OwnStoreys& own = {});
inline constexpr std::size_t maxReceivers = 20'000'000;

/// The buildings whose outline's middle lies in the region, ascending.
std::vector<std::uint32_t> findBuildingsIn(const City& city, const Region& region);

}  // namespace noonmark
