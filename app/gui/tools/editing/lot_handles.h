#pragma once

#include <QPointF>
#include <optional>
#include <vector>

#include "core/city/city.h"
#include "render/scene/point_marks.h"
#include "render/view/view_ray.h"

namespace noonmark {

/// What can be grabbed of a lot: a corner, an edge, or the mark in the middle of an edge.
struct LotHandle {
    enum class Kind { corner, edge, middle };
    Kind kind = Kind::corner;
    std::size_t index = 0;  ///< of the corner or edge in the outer ring
    bool operator==(const LotHandle&) const = default;
};

/// The handle at a pixel: a corner before a middle before an edge. The ground is that of `city`.
std::optional<LotHandle> findLotHandle(const Footprint& lot, const City& city, QPointF pixel,
                                       const CameraPose& pose, const ViewLens& lens);

/// The marks of all corners and middles, slightly above the ground.
std::vector<PointMarks::Mark> makeLotMarks(const Footprint& lot, const City& city,
                                           std::optional<std::size_t> selectedCorner);

}  // namespace noonmark
