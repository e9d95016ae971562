#include "app/gui/tools/editing/lot_handles.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace noonmark {

namespace {

constexpr double handleReachPx = 9;
constexpr double edgeReachPx = 6;
constexpr double markAboveGroundM = 0.3;  // as the lines of lots

glm::dvec3 liftedOnto(const City& city, glm::dvec2 point) {
    return {point, double(groundAt(city, point)) + markAboveGroundM};
}

glm::dvec2 corner(const Footprint& lot, std::size_t i) { return glm::dvec2(lot.outer[i % lot.outer.size()]); }

glm::dvec2 middle(const Footprint& lot, std::size_t edge) {
    return (corner(lot, edge) + corner(lot, edge + 1)) / 2.0;
}

double distanceToSegment(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 side = b - a;
    const double square = glm::dot(side, side);
    const double along = square > 0 ? std::clamp(glm::dot(point - a, side) / square, 0.0, 1.0) : 0;
    return glm::distance(point, a + along * side);
}

// The nearest of all handles of one kind, if it is within reach.
template <class Distance>
std::optional<LotHandle> nearestOf(LotHandle::Kind kind, std::size_t count, double reachPx,
                                   const Distance& distancePx) {
    std::optional<LotHandle> nearest;
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<double> far = distancePx(i);
        if (!far || *far > reachPx) continue;
        reachPx = *far;
        nearest = LotHandle{kind, i};
    }
    return nearest;
}

}  // namespace

std::optional<LotHandle> findLotHandle(const Footprint& lot, const City& city, QPointF pixel,
                                       const CameraPose& pose, const ViewLens& lens) {
    const glm::dvec2 here(pixel.x(), pixel.y());
    const std::size_t count = lot.outer.size();
    const auto onScreen = [&](glm::dvec2 point) { return pixelOf(pose, lens, liftedOnto(city, point)); };
    const auto farFrom = [&](glm::dvec2 point) -> std::optional<double> {
        const auto there = onScreen(point);
        return there ? std::optional(glm::distance(*there, here)) : std::nullopt;
    };
    using Kind = LotHandle::Kind;
    auto found =
        nearestOf(Kind::corner, count, handleReachPx, [&](std::size_t i) { return farFrom(corner(lot, i)); });
    if (!found)
        found = nearestOf(Kind::middle, count, handleReachPx,
                          [&](std::size_t i) { return farFrom(middle(lot, i)); });
    if (found) return found;
    return nearestOf(Kind::edge, count, edgeReachPx, [&](std::size_t i) -> std::optional<double> {
        const auto a = onScreen(corner(lot, i)), b = onScreen(corner(lot, i + 1));
        return a && b ? std::optional(distanceToSegment(here, *a, *b)) : std::nullopt;
    });
}

std::vector<PointMarks::Mark> makeLotMarks(const Footprint& lot, const City& city,
                                           std::optional<std::size_t> selectedCorner) {
    using Shape = PointMarks::Shape;
    std::vector<PointMarks::Mark> marks;
    for (std::size_t i = 0; i < lot.outer.size(); ++i)
        marks.push_back({Shape::middle, liftedOnto(city, middle(lot, i))});
    for (std::size_t i = 0; i < lot.outer.size(); ++i)
        marks.push_back(
            {i == selectedCorner ? Shape::selectedCorner : Shape::corner, liftedOnto(city, corner(lot, i))});
    return marks;
}

}  // namespace noonmark
