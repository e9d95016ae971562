#include "core/accumulate/horizon/open_triangles.h"

#include <fmt/format.h>

#include "core/city/city.h"

namespace noonmark {

void addTriangles(const Part& part, const Grid& grid, double datumM, std::vector<OpenTriangle>& triangles) {
    const TriangleMesh mesh = part.mesh ? *part.mesh : meshOf(part);
    const auto corner = [&](std::uint32_t index) {
        const glm::dvec3 point(mesh.vertices[index]);
        return glm::dvec3((point.x - grid.westM) / grid.cellM - 0.5,
                          (point.y - grid.southM) / grid.cellM - 0.5, point.z - datumM);
    };
    for (const glm::uvec3& triangle : mesh.triangles)
        triangles.push_back({corner(triangle.x), corner(triangle.y), corner(triangle.z)});
}

OpenTriangles trianglesOf(const OpenParts& parts, const Grid& grid, double datumM) {
    OpenTriangles triangles;
    for (const OpenPart& open : parts) {
        const auto first = std::uint32_t(triangles.all.size());
        addTriangles(*open.part, grid, datumM, triangles.all);
        if (triangles.owners.empty() || triangles.owners.back().building != open.building)
            triangles.owners.push_back({open.building, first, first});
        triangles.owners.back().end = std::uint32_t(triangles.all.size());
    }
    return triangles;
}

Result<void> checkTriangles(std::size_t count) {
    if (count <= OpenTriangles::most) return {};
    return failure(
        fmt::format("The horizon sweep takes what stands on the ground and up to {} triangles of parts that "
                    "hang, and in reach there are {}",
                    OpenTriangles::most, count),
        "engine", "Choose projected shadows or the ray reference");
}

Result<OpenTriangles> openTriangles(const OpenParts& parts, const Grid& grid, double datumM) {
    OpenTriangles triangles = trianglesOf(parts, grid, datumM);
    if (const auto able = checkTriangles(triangles.all.size()); !able)
        return tl::make_unexpected(able.error());
    return triangles;
}

}  // namespace noonmark
