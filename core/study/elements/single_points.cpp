#include "core/study/elements/single_points.h"

#include "core/study/settle_point.h"

namespace noonmark {

Result<PointReceivers> placeListedPoints(const City& city, const std::vector<ListedPoint>& points,
                                         Warnings& warnings, const std::stop_token& stop) {
    constexpr glm::dvec2 half{0.5, 0.5};
    PointReceivers placed;
    for (const ListedPoint& point : points) {
        if (stop.stop_requested()) return cancelled();
        PointQuestion question{.at = point.at, .heightM = point.heightM, .facingDeg = point.facingDeg};
        const auto settled = settlePoint(city, question);
        if (!settled) {
            warnings.push_back({WarningKind::leftOut, settled.error().what, point.id});
            continue;
        }
        placed.points.positions.push_back(settled->point.position);
        placed.points.normals.push_back(settled->point.normal);
        placed.elements.push_back({.id = point.id, .kind = ElementKind::point});
        placed.panes.push_back({-half, half});
    }
    return placed;
}

}  // namespace noonmark
