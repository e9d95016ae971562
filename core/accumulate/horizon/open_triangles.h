#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/accumulate/horizon/wall_list.h"
#include "core/city/building.h"
#include "core/receivers/grid.h"
#include "core/result.h"

namespace noonmark {

/// A triangle of a part that hangs: x and y in cells, z in metres above the datum.
using OpenTriangle = std::array<glm::dvec3, 3>;

/// The triangles of a part. `datumM`: local z that heights count from.
void addTriangles(const Part& part, const Grid& grid, double datumM, std::vector<OpenTriangle>& triangles);

/// What hangs, building by building.
struct OpenTriangles {
    static constexpr std::size_t most = 50'000;  ///< each is looked at from every cell that it may shade
    struct Owner {
        std::uint32_t building;  ///< as in OpenPart
        std::uint32_t first, end;
    };
    std::vector<OpenTriangle> all;
    std::vector<Owner> owners;  ///< in the order of `all`

    [[nodiscard]] bool empty() const { return all.empty(); }
    [[nodiscard]] std::span<const OpenTriangle> of(const Owner& owner) const {
        return std::span(all).subspan(owner.first, owner.end - owner.first);
    }
};

/// `parts`: those of one building side by side.
OpenTriangles trianglesOf(const OpenParts& parts, const Grid& grid, double datumM);

/// The same. Error: more than `most`.
Result<OpenTriangles> openTriangles(const OpenParts& parts, const Grid& grid, double datumM);

/// Error: so many are more than `most`.
Result<void> checkTriangles(std::size_t count);

}  // namespace noonmark
