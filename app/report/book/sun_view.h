#pragma once

#include <QImage>
#include <stop_token>

#include "app/report/book/diagram.h"
#include "core/base/result.h"
#include "core/engines/ray/ray_scene.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// What views from the sun show: the scenario's city with its rays, and the places on its ground.
class SunViewScene {
public:
    /// `area`: the ground that the views show, local metres; they show all of the proposal, too. Error: out
    /// of memory, or cancelled().
    static Result<SunViewScene> make(const DiagramScene& scene, const Box2& area,
                                     const std::stop_token& stop) {
        return make(scene, area, stop, scene.proposal);
    }
    /// The same with other buildings that all views must show: those of two cities then match.
    static Result<SunViewScene> make(const DiagramScene& scene, const Box2& area, const std::stop_token& stop,
                                     const City& shown);

    /// The city as the sun sees it, without perspective: whatever is visible is sunlit, and what is hidden is
    /// in shadow. One ray for each pixel, so overlaps are exact. `size` in pixels, positive. Some 10^7 rays a
    /// second and core.
    [[nodiscard]] QImage paint(const SunStep& sun, const QSize& size) const;

private:
    SunViewScene(RayScene rays, std::vector<bool> isProposal, QImage places, const Box2& area,
                 std::vector<glm::vec3> shown)
        : rays_(std::move(rays)),
          isProposal_(std::move(isProposal)),
          places_(std::move(places)),
          area_(area),
          shown_(std::move(shown)) {}

    [[nodiscard]] bool isPlace(glm::vec2 ground) const;

    RayScene rays_;
    std::vector<bool> isProposal_;  ///< by building
    QImage places_;                 ///< cells of 1 m or more over the area: not 0 on a place
    Box2 area_;
    std::vector<glm::vec3> shown_;  ///< points that lie in every view
};

}  // namespace noonmark
