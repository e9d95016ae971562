#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/engines/ray/ray_scene.h"
#include "core/receivers/point_receivers.h"

namespace noonmark {

/// A box along the axes, local metres.
struct VisibleBox {
    glm::vec3 low{0};
    glm::vec3 high{0};
};

/// A camera in perspective or parallel projection, and its image size. Local metres; forward, right and up
/// are orthogonal unit vectors.
struct PixelCamera {
    glm::dvec3 eye{0};
    glm::dvec3 forward{0, 1, 0};
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 up{0, 0, 1};
    double verticalDeg = 40;  ///< vertical angle of view, above 0, below 180
    double heightM = 0;  ///< above 0: a parallel projection, whose image is so high; verticalDeg is unused
    int widthPx = 1;     ///< 1 to 16384
    int heightPx = 1;    ///< 1 to 16384
    /// Only what lies inside is seen; faces seen from behind, the inside of what the box cuts, are not.
    std::optional<VisibleBox> section{};
};

/// A camera at `eye` that looks at `target`, upright; if it looks straight down, north is up.
PixelCamera makeCamera(glm::dvec3 eye, glm::dvec3 target, double verticalDeg, int widthPx, int heightPx);

/// The line of sight through the centre of a pixel; column 0 is the left, row 0 the TOP.
struct LineOfSight {
    glm::dvec3 origin{0};     ///< the eye; in a parallel projection a point beside it
    glm::dvec3 direction{0};  ///< not normalised: its component along `forward` is 1
};
LineOfSight lineThrough(const PixelCamera& camera, int column, int row);

/// Samples a metre, seen at right angles, at a depth of so many metres along `forward`.
double samplesPerMetre(const PixelCamera& camera, double depthM);

/// The surface points that the pixels of an image show.
struct VisibleSurface {
    SurfacePoints points;              ///< in pixel order, without sky pixels
    std::vector<std::uint32_t> pixel;  ///< of each point: row x widthPx + column, row 0 the TOP; ascending
};

/// The surface point at the centre of each pixel: the first hit in `scene`, or, if `flatGround` (a city
/// without terrain), the plane z = 0. Normals face the eye. Points farther than farthestVisibleM from the eye
/// count as sky. In a parallel projection nothing behind the eye is seen. Error: a camera out of range;
/// cancelled(). Uses all cores, some 0.2 us per pixel and core.
Result<VisibleSurface> findVisibleSurface(const RayScene& scene, bool flatGround, const PixelCamera& camera,
                                          const std::stop_token& stop = {});
inline constexpr double farthestVisibleM = 30000;

}  // namespace noonmark
