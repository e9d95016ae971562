#pragma once

#include <unordered_map>
#include <vector>

#include "core/study/elements/element_map.h"

namespace noonmark {

/// Hours of sun of the points on a surface.
struct SurfaceHours {
    std::size_t points = 0;
    double mean = 0, least = 0, most = 0;  ///< hours a day
};

/// Finds the points of a map that lie on a flat polygon.
class PointsOnSurfaces {
public:
    static constexpr double maxDistanceM = 0.3;        ///< from the plane of the polygon
    explicit PointsOnSurfaces(const ElementMap& map);  ///< the map must outlive it

    /// `rings`: the outer one, then holes; local metres, of finite coordinates, counterclockwise seen from
    /// outside. Returns indices of elements that face as the polygon does and lie inside it.
    [[nodiscard]] std::vector<std::size_t> find(const std::vector<std::vector<glm::dvec3>>& rings) const;

private:
    using Cell = std::pair<int, int>;
    struct HashOfCell {
        std::size_t operator()(const Cell& cell) const {
            return std::size_t(cell.first) * 73856093U ^ std::size_t(cell.second) * 19349663U;
        }
    };
    const ElementMap& map_;
    std::unordered_map<Cell, std::vector<std::size_t>, HashOfCell> cells_;
};

SurfaceHours sumHours(const ElementMap& map, const std::vector<std::size_t>& points);

}  // namespace noonmark
