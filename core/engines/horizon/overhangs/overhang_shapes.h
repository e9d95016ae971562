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

/// A part with plumb walls that hangs. Cells and metres above a datum, as are all shapes.
struct OverhangPrism {
    std::vector<std::vector<glm::dvec2>> rings;  ///< outer one and holes
    double bottomM, topM;
};

/// A triangle of another part that hangs.
using OverhangTriangle = std::array<glm::dvec3, 3>;

/// What hangs of one building, each part whole where it can be.
struct OverhangShapes {
    static constexpr std::size_t most =
        50'000;  ///< of a city: each is looked at from every cell that it may shade

    std::uint32_t building = 0;  ///< as in OverhangPart
    std::vector<OverhangPrism> prisms;
    std::vector<OverhangTriangle> triangles;
    glm::dvec2 low{1e30}, high{-1e30};  ///< bounds
    double topM = -1e30;

    [[nodiscard]] std::size_t size() const { return prisms.size() + triangles.size(); }
};

/// Some of what hangs; not owned.
using OverhangList = std::vector<const OverhangShapes*>;

/// Building by building. `parts`: those of one side by side. `datumM`: local z that heights count from.
std::vector<OverhangShapes> toOverhangShapes(const OverhangParts& parts, const Grid& grid, double datumM);

/// The same. Error: more than `most`.
Result<std::vector<OverhangShapes>> makeOverhangShapes(const OverhangParts& parts, const Grid& grid,
                                                       double datumM);

OverhangList listOf(std::span<const OverhangShapes> shapes);

/// Error: so many are more than OverhangShapes::most.
Result<void> checkOverhangCount(std::size_t count);

}  // namespace noonmark
