#pragma once

#include "core/sun/sun_paths.h"
#include "render/scene/dome_marks.h"

namespace noonmark {

/// Where a sun path dome stands.
struct DomePlace {
    glm::dvec3 centre{0};  ///< local metres
    double radiusM = 1;    ///< > 0
    bool operator==(const DomePlace&) const = default;
};

/// A dome that fits the view of a camera, also in a narrow one: around `centre`, or else the ground under the
/// camera's target (`groundM`: local z), slightly above it. Turning the camera around its target changes
/// nothing.
DomePlace placeDome(const CameraPose& pose, const ViewLens& lens, double groundM,
                    const std::optional<glm::dvec3>& centre);

/// How badly a dome that stands at `shown` represents one at `wanted`.
enum class DomeDrift { none, small, large };
DomeDrift compareDomes(const DomePlace& shown, const DomePlace& wanted);

/// The lines and names of a dome: paths, hours, the horizon with the quarters of the sky. January to June are
/// named where the sun rises, July to December where it sets, hours where they are highest.
/// `frameFromPlace`: of the observer of the paths.
DomeMarks::Net drawDome(const SunPaths& paths, const glm::dmat3& frameFromPlace, const DomePlace& place);

/// The path of a day and, if `towardsSun` (a unit vector) is above the horizon, the sun with a line to the
/// centre.
DomeMarks::Sun drawDomeSun(const std::vector<SunCurve>& path, const glm::dvec3& towardsSun,
                           const DomePlace& place);

}  // namespace noonmark
