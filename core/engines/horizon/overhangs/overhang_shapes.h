#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/engines/horizon/geometry/wall_list.h"
#include "core/geo/grid.h"

namespace noonmark {

/// An overhang with vertical walls. In cells and in metres above a datum, like all shapes.
struct OverhangPrism {
    std::vector<std::vector<glm::dvec2>> rings;  ///< outer ring and holes
    double bottomM, topM;
};

/// A triangle of an overhang that is not a prism.
using OverhangTriangle = std::array<glm::dvec3, 3>;

/// The overhangs of one building; each is a prism where possible.
struct OverhangShapes {
    static constexpr std::size_t most =
        50'000;  ///< limit per city: each is examined from every cell that it may shade

    std::uint32_t building = 0;  ///< as in OverhangPart
    std::vector<OverhangPrism> prisms;
    std::vector<OverhangTriangle> triangles;
    glm::dvec2 low{1e30}, high{-1e30};  ///< bounds
    double topM = -1e30;

    [[nodiscard]] std::size_t size() const { return prisms.size() + triangles.size(); }
};

/// Pointers to overhangs; not owned.
using OverhangList = std::vector<const OverhangShapes*>;

/// One entry per building. `parts`: those of one building must be adjacent. `datumM`: local z from which
/// heights are measured.
std::vector<OverhangShapes> toOverhangShapes(const OverhangParts& parts, const Grid& grid, double datumM);

/// The same. Error if there are more than `most`.
Result<std::vector<OverhangShapes>> makeOverhangShapes(const OverhangParts& parts, const Grid& grid,
                                                       double datumM);

OverhangList listOf(std::span<const OverhangShapes> shapes);

/// Error if the count exceeds OverhangShapes::most.
Result<void> checkOverhangCount(std::size_t count);

}  // namespace noonmark
