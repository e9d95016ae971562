#include "render/scene/city_bodies.h"

#include <QVector2D>
#include <QVector3D>
#include <QVector4D>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QLayer>
#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <iterator>
#include <span>

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

namespace {

constexpr QColor hoveredColour{0x5b, 0x9b, 0xe0, 90};
constexpr QColor selectedColour{0x2f, 0x7d, 0xe0, 165};
constexpr QColor selectedEdgeColour{0x05, 0x3d, 0x30};
constexpr QColor floorColour{0x02, 0x2c, 0x40};
constexpr float floorHazeM = 5000;  // from further away, floors would lie side by side
constexpr QColor lotColour{0x0a, 0x6f, 0x4f, 235};
constexpr QColor handleColour{0xc2, 0x18, 0x8b, 255};
constexpr QColor litHandleColour{0xff, 0x5c, 0xc8, 255};
constexpr QColor pinColour{0xd5, 0x5e, 0x00, 255};
constexpr QColor worstColour{0x7b, 0x0d, 0x2c, 255};
// Towards the eye, as shares of the depth: between the faces of the city and its edges (edge.vert).
constexpr std::array colouredLifts{0.00001F, 0.00002F};  // of OverlayBodies::ColouredBy
constexpr float tintLift = 0.00003F;
constexpr double pinPx = 34, worstPx = 24;

glm::vec4 componentsOf(const QColor& c) { return {c.redF(), c.greenF(), c.blueF(), c.alphaF()}; }
QVector4D vectorOf(const QColor& c) { return QVector4D(c.redF(), c.greenF(), c.blueF(), c.alphaF()); }

template <class Node>
void drop(Node*& node) {
    delete node;
    node = nullptr;
}

}  // namespace

OverlayBodies::OverlayBodies(Qt3DRender::QLayer* blended, Qt3DRender::QLayer* side, Qt3DCore::QEntity* parent)
    : root_(new Qt3DCore::QEntity(parent)),
      edited_(new Qt3DCore::QEntity(root_)),
      layer_(new Qt3DRender::QLayer(root_)),
      blended_(blended) {
    layer_->setRecursive(true);
    root_->addComponent(layer_);
    edited_->addComponent(side);
    const auto made = [this](const char* name) {
        return new ShaderMaterial(QString::fromLatin1(name), QStringLiteral("overlay"), root_);
    };
    for (const auto& [tint, colour] : {std::pair(Tint::hovered, hoveredColour),
                                       {Tint::selected, selectedColour},
                                       {Tint::proposed, proposalColour}}) {
        of(tint).material = makeTint(componentsOf(colour), tintLift);
        if (tint != Tint::proposed) of(tint).material->blend();
    }
    edge_ = new ShaderMaterial(QStringLiteral("edge"), root_);
    edge_->set(QStringLiteral("edgeColour"), vectorOf(selectedEdgeColour).toVector3D());
    edge_->set(QStringLiteral("hazeDistance"), 1e6F);
    edge_->blend();
    floor_ = new ShaderMaterial(QStringLiteral("edge"), root_);
    floor_->set(QStringLiteral("edgeColour"), vectorOf(floorColour).toVector3D());
    floor_->set(QStringLiteral("hazeDistance"), floorHazeM);
    floor_->blend();
    lots_ = std::make_unique<GroundLines>(lotColour, 2.5F, blended_, root_);
    handle_ = {makeDoubleArrow(float(handlePx)), made("mark"), nullptr, {}};
    lightHandle(false);
    pin_ = {makePin(float(pinPx)), made("mark"), nullptr, {}};
    pin_.material->set(QStringLiteral("tint"), vectorOf(pinColour));
    worst_ = {makePin(float(worstPx)), made("mark"), nullptr, {}};
    worst_.material->set(QStringLiteral("tint"), vectorOf(worstColour));
}

OverlayBodies::~OverlayBodies() {
    lots_.reset();
    delete root_;
}

ShaderMaterial* OverlayBodies::makeTint(glm::vec4 colour, float lift) {
    auto* material = new ShaderMaterial(QStringLiteral("overlay"), root_);
    material->set(QStringLiteral("tint"), QVector4D(colour.r, colour.g, colour.b, colour.a));
    material->set(QStringLiteral("lift"), lift);
    return material;
}

void OverlayBodies::show(Tint tint, const City& some) {
    Body& body = of(tint);
    drop(body.faces);
    drop(body.edges);
    if (some.buildings.empty()) return;
    const CityArrays arrays = makeBuildingArrays(some);
    body.faces = makeArrayEntity(
        makeIndexedGeometry(Qt3DRender::QGeometryRenderer::Triangles, arrays.points, arrays.triangles),
        *body.material, edited_, tint == Tint::proposed ? nullptr : blended_);
    if (tint != Tint::proposed) return;
    body.edges = makeArrayEntity(
        makeIndexedGeometry(Qt3DRender::QGeometryRenderer::Lines, arrays.points, arrays.edges), *edge_,
        edited_, blended_);
}

void OverlayBodies::showColoured(const std::vector<Coloured>& groups, ColouredBy by) {
    ColouredBodies& coloured = coloured_[std::size_t(by)];
    for (Body& body : coloured.bodies) {
        drop(body.faces);
        drop(body.material);
    }
    coloured = {};
    for (const Coloured& group : groups) {
        if (group.some.buildings.empty()) continue;
        const CityArrays arrays = makeBuildingArrays(group.some, 0);
        Body body{makeTint({group.colour, 1}, colouredLifts[std::size_t(by)])};
        body.faces = makeArrayEntity(
            makeIndexedGeometry(Qt3DRender::QGeometryRenderer::Triangles, arrays.points, arrays.triangles),
            *body.material, edited_);
        coloured.bodies.push_back(body);
        coloured.count += group.some.buildings.size();
    }
}

void OverlayBodies::showLines(const std::vector<GroundLine>& lines) { lots_->show(lines); }

void OverlayBodies::showFloors(const std::vector<std::vector<glm::vec3>>& rings) {
    drop(floors_);
    std::vector<glm::vec3> points;
    std::vector<std::uint32_t> ends;
    for (const std::vector<glm::vec3>& ring : rings) {
        const auto first = std::uint32_t(points.size()), count = std::uint32_t(ring.size());
        points.insert(points.end(), ring.begin(), ring.end());
        for (std::uint32_t i = 0; i < count; ++i)
            ends.insert(ends.end(), {first + i, first + (i + 1) % count});
    }
    if (points.empty()) return;
    floors_ = makeArrayEntity(makeIndexedGeometry(Qt3DRender::QGeometryRenderer::Lines, points, ends),
                              *floor_, edited_, blended_);
}

void OverlayBodies::show(Mark& mark, std::optional<glm::dvec3> at, Qt3DCore::QEntity* parent) {
    mark.at = at;
    if (!at) return drop(mark.entity);
    mark.material->set(QStringLiteral("anchor"), QVector3D(float(at->x), float(at->y), float(at->z)));
    if (mark.entity) return;
    mark.entity = makeArrayEntity(makeMeshGeometry(mark.shape), *mark.material, parent);
}

void OverlayBodies::showHandle(std::optional<glm::dvec3> foot) { show(handle_, foot, edited_); }

void OverlayBodies::showPin(std::optional<glm::dvec3> tip) { show(pin_, tip, root_); }

void OverlayBodies::showWorstSpot(std::optional<glm::dvec3> tip) { show(worst_, tip, edited_); }

void OverlayBodies::showEditing(bool shown) {
    for (Qt3DCore::QEntity* one : {of(Tint::hovered).faces, of(Tint::selected).faces, handle_.entity})
        if (one) one->setEnabled(shown);
}

void OverlayBodies::lightHandle(bool lit) {
    handle_.material->set(QStringLiteral("tint"), vectorOf(lit ? litHandleColour : handleColour));
}

std::optional<glm::dvec2> OverlayBodies::handlePixel(const CameraPose& pose, const ViewLens& lens) const {
    if (!handle_.at) return std::nullopt;
    const auto foot = pixelOf(pose, lens, *handle_.at);
    if (!foot) return foot;
    return *foot - glm::dvec2(0, handlePx / 2);
}

void OverlayBodies::setLens(const CameraPose& pose, const ViewLens& lens) {
    const double atOneMetre = metresPerPixel(pose, lens, 1);
    for (const Mark* mark : {&handle_, &pin_, &worst_})
        mark->material->set(QStringLiteral("metresPerPixel"), float(atOneMetre));
    lots_->setViewSize({float(lens.widthPx), float(lens.heightPx)});
}

}  // namespace noonmark
