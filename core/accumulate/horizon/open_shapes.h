#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/accumulate/horizon/wall_list.h"
#include "core/receivers/grid.h"
#include "core/result.h"

namespace noonmark {

/// A part with plumb walls that hangs. Cells and metres above a datum, as are all shapes.
struct OpenPrism {
    std::vector<std::vector<glm::dvec2>> rings;  ///< outer one and holes
    double bottomM, topM;
};

/// A triangle of another part that hangs.
using OpenTriangle = std::array<glm::dvec3, 3>;

/// What hangs of one building, each part whole where it can be.
struct OpenShapes {
    static constexpr std::size_t most =
        50'000;  ///< of a city: each is looked at from every cell that it may shade

    std::uint32_t building = 0;  ///< as in OpenPart
    std::vector<OpenPrism> prisms;
    std::vector<OpenTriangle> triangles;
    glm::dvec2 low{1e30}, high{-1e30};  ///< bounds
    double topM = -1e30;

    [[nodiscard]] std::size_t size() const { return prisms.size() + triangles.size(); }
};

/// Some of what hangs; not owned.
using OpenList = std::vector<const OpenShapes*>;

/// Building by building. `parts`: those of one side by side. `datumM`: local z that heights count from.
std::vector<OpenShapes> shapesOf(const OpenParts& parts, const Grid& grid, double datumM);

/// The same. Error: more than `most`.
Result<std::vector<OpenShapes>> openShapes(const OpenParts& parts, const Grid& grid, double datumM);

OpenList listOf(std::span<const OpenShapes> shapes);

/// Error: so many are more than OpenShapes::most.
Result<void> checkShapes(std::size_t count);

}  // namespace noonmark
