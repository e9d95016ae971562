#include "core/engines/horizon/cache/overhang_cache.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/engines/horizon/cache/remove_at.h"

namespace noonmark {

std::size_t OverhangCache::reaching(const Grid& grid, double lowestTan,
                                    std::span<const std::uint64_t> but) const {
    const glm::dvec2 last(grid.columns, grid.rows);
    std::size_t size = 0;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        const OverhangShapes& shapes = shapes_[i];
        const glm::dvec2 apart = glm::max(glm::max(shapes.low - last, -shapes.high), glm::dvec2(0));
        const double reach = shapes.topM / (grid.cellM * lowestTan) + 2;
        if (glm::length(apart) <= reach && !std::ranges::binary_search(but, owners_[i]))
            size += shapes.size();
    }
    return size;
}

void OverhangCache::add(OverhangShapes shapes, std::uint64_t owner) {
    shapes_.push_back(std::move(shapes));
    owners_.push_back(owner);
}

std::vector<OverhangShapes> OverhangCache::remove(std::span<const std::uint64_t> owners) {
    return removeAt(shapes_, owners_, owners);
}

void OverhangCache::across(const ShadowAxes& axes, const ShadowExtent& extent, double lowestTan,
                           double alongPerMetre, OverhangList& list) const {
    list.clear();
    for (const OverhangShapes& shapes : shapes_) {
        ShadowExtent own;
        own.addBox(axes, shapes.low, shapes.high);
        const double reach = shapes.topM * alongPerMetre / lowestTan + 2;
        if (own.highQ < extent.lowQ || own.lowQ > extent.highQ || own.lowAlong > extent.highAlong ||
            own.highAlong + reach < extent.lowAlong)
            continue;
        list.push_back(&shapes);
    }
}

}  // namespace noonmark
