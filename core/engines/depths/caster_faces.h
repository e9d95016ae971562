#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/city/city.h"
#include "core/engines/common/sun_interval.h"
#include "core/engines/depths/map_frame.h"

namespace noonmark {

/// A flat convex face, counter-clockwise as seen from outside.
struct CasterFace {
    std::array<std::uint32_t, 4> corner{};  ///< indices in CasterFaces::points
    std::uint8_t corners = 3;               ///< number of corners, 3 or 4
    bool twoSided = false;  ///< part of a mesh that is not closed: also casts shadow if seen from behind
};

/// All faces of some buildings and of the terrain in the form that depth maps use: walls as quadrilaterals,
/// caps and meshes as triangles. Terrain is the top of the solid below it. Local metres.
struct CasterFaces {
    std::vector<glm::vec3> points;
    std::vector<CasterFace> faces;
};

/// `buildings`: indices in the city. O(points log points), all cores. Returns soon after a stop request with
/// an incomplete result; the caller must check the token.
CasterFaces makeCasterFaces(const City& city, std::span<const std::uint32_t> buildings,
                            const std::stop_token& stop = {});

/// The faces of closed solids.
CasterFaces makeCasterFaces(const TriangleMesh& closed);

/// The faces of a closed solid that a depth map contains.
enum class CasterSide {
    /// Faces seen by the sun, as in the paper: lit surfaces lie on their own faces, so a bias is needed.
    towardsSun,
    /// Faces not seen by the sun. Everything outside all solids has the same shadow, half the faces suffice,
    /// and no lit surface is close to the faces that it is compared with.
    awayFromSun,
};

/// The extent of an interval's receivers, for culling.
struct ReceiverExtent {
    double lowestW = 0;  ///< height of the lowest receiver above the map's plane; faces below it cast no
                         ///< shadow on receivers
    /// Whether a receiver may lie in this box of the map's plane, metres; null: anywhere on the map.
    std::function<bool(glm::dvec2 low, glm::dvec2 high)> any;
};

/// The faces that may shade a receiver at some step of an interval, in the frame of its maps. All its slices
/// are drawn from them.
struct IntervalCasters {
    std::vector<glm::dvec3> points;  ///< MapFrame::placed
    std::vector<CasterFace> faces;   ///< corners are indices in `points`
    std::uint64_t turnedOther = 0;  ///< culled faces: never on the side that is drawn, or below all receivers
    std::uint64_t outOfReach = 0;   ///< culled faces: their shadow meets no receiver
};

/// Conservative: never culls a face that could shade a receiver. During an interval the shadow of a point
/// moves on a straight line, so its positions at both ends bound it. O(faces). `placed`: MapFrame::placed of
/// faces.points.
IntervalCasters placeCasters(const CasterFaces& faces, const std::vector<glm::dvec3>& placed,
                             const MapFrame& frame, const SunInterval& interval, CasterSide side,
                             const ReceiverExtent& receivers);

}  // namespace noonmark
