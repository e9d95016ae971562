#include "core/engines/horizon/overhangs/overhang_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>

#include "core/city/city.h"

namespace noonmark {

namespace {

bool isPrism(const Part& part) { return !part.mesh && part.footprint.outer.size() >= 3; }

/// Adds the parts of a building to its shapes.
class ShapeBuilder {
public:
    ShapeBuilder(const Grid& grid, double datumM, OverhangShapes& shapes)
        : grid_(grid), datumM_(datumM), shapes_(shapes) {}

    void add(const Part& part) {
        if (isPrism(part))
            addPrism(part);
        else
            addTriangles(part.mesh ? *part.mesh : meshOf(part));
    }

private:
    void addPrism(const Part& part) {
        OverhangPrism prism{
            {cellsOf(part.footprint.outer)}, double(part.bottomM) - datumM_, double(part.topM) - datumM_};
        for (const Ring& hole : part.footprint.holes) prism.rings.push_back(cellsOf(hole));
        for (const glm::dvec2 corner : prism.rings.front()) grow({corner, prism.topM});
        shapes_.prisms.push_back(std::move(prism));
    }

    void addTriangles(const TriangleMesh& mesh) {
        for (const glm::uvec3& triangle : mesh.triangles) {
            shapes_.triangles.push_back({cornerOf(mesh.vertices[triangle.x]),
                                         cornerOf(mesh.vertices[triangle.y]),
                                         cornerOf(mesh.vertices[triangle.z])});
            for (const glm::dvec3 corner : shapes_.triangles.back()) grow(corner);
        }
    }

    void grow(glm::dvec3 corner) {
        shapes_.low = glm::min(shapes_.low, glm::dvec2(corner));
        shapes_.high = glm::max(shapes_.high, glm::dvec2(corner));
        shapes_.topM = std::max(shapes_.topM, corner.z);
    }

    [[nodiscard]] std::vector<glm::dvec2> cellsOf(const Ring& ring) const {
        std::vector<glm::dvec2> cells;
        for (const glm::vec2 corner : ring) cells.emplace_back(cornerOf({corner, 0}));
        return cells;
    }

    [[nodiscard]] glm::dvec3 cornerOf(glm::vec3 local) const {
        return {(double(local.x) - grid_.westM) / grid_.cellM - 0.5,
                (double(local.y) - grid_.southM) / grid_.cellM - 0.5, double(local.z) - datumM_};
    }

    const Grid& grid_;
    double datumM_;
    OverhangShapes& shapes_;
};

}  // namespace

std::vector<OverhangShapes> toOverhangShapes(const OverhangParts& parts, const Grid& grid, double datumM) {
    std::vector<OverhangShapes> shapes;
    for (const OverhangPart& overhangs : parts) {
        if (shapes.empty() || shapes.back().building != overhangs.building)
            shapes.push_back({.building = overhangs.building});
        ShapeBuilder(grid, datumM, shapes.back()).add(*overhangs.part);
    }
    return shapes;
}

Result<std::vector<OverhangShapes>> makeOverhangShapes(const OverhangParts& parts, const Grid& grid,
                                                       double datumM) {
    std::vector<OverhangShapes> shapes = toOverhangShapes(parts, grid, datumM);
    std::size_t count = 0;
    for (const OverhangShapes& some : shapes) count += some.size();
    if (const auto able = checkOverhangCount(count); !able) return tl::make_unexpected(able.error());
    return shapes;
}

OverhangList listOf(std::span<const OverhangShapes> shapes) {
    OverhangList list;
    for (const OverhangShapes& some : shapes) list.push_back(&some);
    return list;
}

Result<void> checkOverhangCount(std::size_t count) {
    if (count <= OverhangShapes::most) return {};
    return unsupported(
        fmt::format("The horizon sweep takes up to {} overhanging prisms and triangles, and {} are "
                    "within reach",
                    OverhangShapes::most, count),
        "engine", "Choose projected shadows or the ray reference");
}

}  // namespace noonmark
