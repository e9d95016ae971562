#include "core/engines/horizon/overhangs/overhang_layers.h"

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
    if (count <= OverhangShapes::maximum) return {};
    return unsupported(
        fmt::format("The horizon sweep takes up to {} overhanging prisms and triangles, and {} are "
                    "within reach",
                    OverhangShapes::maximum, count),
        "engine", "Choose projected shadows or the ray reference");
}

void OverhangLayers::set(std::span<const OverhangShapes* const> shapes, const ShadowAxes& axes,
                         double alongPerMetre) {
    alongPerMetre_ = alongPerMetre;
    strips_.clear();
    layers_.clear();
    for (const OverhangShapes* some : shapes) {
        for (const OverhangTriangle& triangle : some->triangles) add(triangle, axes);
        for (const OverhangPrism& prism : some->prisms) add(prism, axes);
    }
}

void OverhangLayers::add(const OverhangTriangle& triangle, const ShadowAxes& axes) {
    extent_ = {};
    std::array<Corner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const ShadowAxes::Point point = axes.from(glm::dvec2(triangle[i]));
        corners[i] = {point.q, point.along, triangle[i].z * alongPerMetre_};
        extent_.add(point);
    }
    std::ranges::sort(corners, {}, &Corner::q);
    const auto& [low, middle, high] = corners;
    const double rise = std::max({low.rise, middle.rise, high.rise});
    if (rise <= 0 || !(low.q < high.q)) return;
    // The point of the longest side at the q of the middle corner.
    const double t = (middle.q - low.q) / (high.q - low.q);
    const Corner across{middle.q, low.along + t * (high.along - low.along),
                        low.rise + t * (high.rise - low.rise)};
    across_.resize(std::max<std::size_t>(across_.size(), 1));
    addStrip(low, across, low, middle);
    addStrip(across, high, middle, high);
    addLayers(false, rise);
}

// The strip between side a1-a2 and side b1-b2, which share one end.
void OverhangLayers::addStrip(const Corner& a1, const Corner& a2, const Corner& b1, const Corner& b2) {
    if (!(a1.q < a2.q)) return;
    const auto side = [](const Corner& from, const Corner& to) {
        const double width = to.q - from.q;
        return OverhangStrip::Side{from.along, (to.along - from.along) / width, from.rise,
                                   (to.rise - from.rise) / width};
    };
    const bool aIsNear = a1.along + a2.along > b1.along + b2.along;
    const OverhangStrip::Side a = side(a1, a2), b = side(b1, b2);
    across_[0].push_back({a1.q, a2.q, aIsNear ? a : b, aIsNear ? b : a});
}

void OverhangLayers::add(const OverhangPrism& prism, const ShadowAxes& axes) {
    if (prism.topM <= 0) return;
    extent_ = {};
    findEdges(prism, axes);
    const double bottom = prism.bottomM * alongPerMetre_, top = prism.topM * alongPerMetre_;
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i)
        addAcross(corners_[i], corners_[i + 1], bottom, top);
    addLayers(true, top);
}

void OverhangLayers::findEdges(const OverhangPrism& prism, const ShadowAxes& axes) {
    edges_.clear();
    corners_.clear();
    for (const std::vector<glm::dvec2>& ring : prism.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            ShadowAxes::Point a = axes.from(ring[i]), b = axes.from(ring[(i + 1) % ring.size()]);
            extent_.add(a);
            corners_.push_back(a.q);
            if (b.q < a.q) std::swap(a, b);
            if (a.q < b.q) edges_.push_back({a.q, b.q, a.along, (b.along - a.along) / (b.q - a.q)});
        }
    std::ranges::sort(corners_);
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    std::ranges::sort(edges_, {}, &Edge::lowQ);
}

// Between two neighbouring corners, the interior lies from each odd wall to the next even one, for any
// outline.
void OverhangLayers::addAcross(double lowQ, double highQ, double bottom, double top) {
    crossed_.clear();
    for (const Edge& edge : edges_) {
        if (edge.lowQ > lowQ) break;
        if (edge.highQ >= highQ) crossed_.push_back(&edge);
    }
    const double middle = (lowQ + highQ) / 2;
    std::ranges::sort(crossed_, {}, [&](const Edge* edge) { return edge->at(middle); });
    for (std::size_t i = 0; i + 1 < crossed_.size(); i += 2) {
        if (across_.size() <= i / 2) across_.emplace_back();
        const Edge &far = *crossed_[i], &near = *crossed_[i + 1];
        across_[i / 2].push_back(
            {lowQ, highQ, {near.at(lowQ), near.slope, top, 0}, {far.at(lowQ), far.slope, bottom, 0}});
    }
}

void OverhangLayers::addLayers(bool solid, double rise) {
    for (std::vector<OverhangStrip>& strips : across_) {
        if (strips.empty()) break;
        const std::size_t first = strips_.size();
        strips_.insert(strips_.end(), strips.begin(), strips.end());
        layers_.push_back({first, strips_.size(), solid, strips.front().lowQ, strips.back().highQ,
                           extent_.lowAlong, extent_.highAlong, rise});
        strips.clear();
    }
}

}  // namespace noonmark
