#include "render/scene/building_bodies.h"

#include <Qt3DCore/QEntity>
#include <algorithm>
#include <iterator>
#include <span>

#include "render/scene/array_entity.h"
#include "render/scene/shader_material.h"

namespace noonmark {

namespace {

// Shows a building, or hides it by making its triangles and lines degenerate, so that they are not drawn.
void change(ArrayGeometry* geometry, const std::vector<std::uint32_t>& indices,
            const std::vector<std::size_t>& starts, std::uint32_t building, bool shown) {
    if (!geometry) return;
    const auto own = std::span(indices).subspan(starts[building], starts[building + 1] - starts[building]);
    if (shown) return geometry->changeIndices(starts[building], own);
    geometry->changeIndices(starts[building],
                            std::vector<std::uint32_t>(own.size(), own.empty() ? 0 : own.front()));
}

}  // namespace

BuildingBodies::BuildingBodies(std::shared_ptr<const CityArrays> arrays, const Materials& materials,
                               const Layers& layers, Qt3DCore::QEntity* parent)
    : arrays_(std::move(arrays)) {
    if (!arrays_->triangles.empty()) {
        faceArray_ = makeIndexedGeometry(Qt3DRender::QGeometryRenderer::Triangles, arrays_->points,
                                         arrays_->triangles);
        faces_ = makeArrayEntity(faceArray_, materials.faces, parent, layers.side);
        cut_ = makeArrayEntity(faceArray_, materials.cut, parent, layers.side);
        cut_->setEnabled(false);
    }
    if (!arrays_->edges.empty()) {
        edgeArray_ =
            makeIndexedGeometry(Qt3DRender::QGeometryRenderer::Lines, arrays_->points, arrays_->edges);
        edges_ = makeArrayEntity(edgeArray_, materials.edges, parent, layers.blended);
        edges_->addComponent(layers.side);
    }
}

BuildingBodies::~BuildingBodies() {
    delete cut_;
    delete faces_;
    delete edges_;
}

void BuildingBodies::set(std::uint32_t building, bool shown) {
    change(faceArray_, arrays_->triangles, arrays_->triangleStart, building, shown);
    change(edgeArray_, arrays_->edges, arrays_->edgeStart, building, shown);
}

void BuildingBodies::leaveOut(const std::vector<std::uint32_t>& buildings) {
    std::vector<std::uint32_t> changed;
    std::ranges::set_difference(leftOut_, buildings, std::back_inserter(changed));
    for (const std::uint32_t building : changed) set(building, true);
    changed.clear();
    std::ranges::set_difference(buildings, leftOut_, std::back_inserter(changed));
    for (const std::uint32_t building : changed) set(building, false);
    leftOut_ = buildings;
}

void BuildingBodies::showFaces(bool shown) {
    if (faces_) faces_->setEnabled(shown);
}

void BuildingBodies::showCut(bool shown) {
    if (cut_) cut_->setEnabled(shown);
}

void BuildingBodies::showEdges(bool shown) {
    if (edges_) edges_->setEnabled(shown);
}

}  // namespace noonmark
