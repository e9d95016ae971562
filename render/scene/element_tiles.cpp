#include "render/scene/element_tiles.h"

#include <QColor>
#include <QVector2D>
#include <QVector4D>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QLayer>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "render/scene/array_entity.h"
#include "render/scene/shader_material.h"

namespace noonmark {

namespace {

constexpr QVector4D tileLineColour{0.0F, 0.85F, 1.0F, 1.0F};  // a colour that no palette has

ArrayGeometry* makeTileGeometry(const std::vector<ElementTiles::Tile>& tiles) {
    std::vector<glm::vec3> points, colours;
    std::vector<std::uint32_t> indices;
    points.reserve(4 * tiles.size());
    colours.reserve(4 * tiles.size());
    indices.reserve(6 * tiles.size());
    for (const ElementTiles::Tile& tile : tiles) {
        const auto first = std::uint32_t(points.size());
        for (const glm::vec3& corner : tile.corners) {
            points.push_back(corner);
            colours.push_back(tile.colour);
        }
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) indices.push_back(first + corner);
    }
    ArrayGeometry* geometry = makeIndexedGeometry(Qt3DRender::QGeometryRenderer::Triangles, points, indices);
    geometry->addPoints(QStringLiteral("tileColour"), colours);
    return geometry;
}

// Distance along the ray to the rectangle, or infinity.
double distanceTo(const ElementTiles::Tile& tile, const ViewRay& ray) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const glm::dvec3 corner(tile.corners[0]);
    const glm::dvec3 along = glm::dvec3(tile.corners[1]) - corner, up = glm::dvec3(tile.corners[3]) - corner;
    const glm::dvec3 normal = glm::cross(along, up);
    const double towards = glm::dot(normal, ray.direction);
    if (towards == 0) return never;
    const double distance = glm::dot(normal, corner - ray.origin) / towards;
    const glm::dvec3 hit = ray.origin + distance * ray.direction - corner;
    const double right = glm::dot(hit, along), above = glm::dot(hit, up);
    const bool inside =
        right >= 0 && right <= glm::dot(along, along) && above >= 0 && above <= glm::dot(up, up);
    return inside && distance >= 0 ? distance : never;
}

}  // namespace

ElementTiles::ElementTiles(Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent)
    : root_(new Qt3DCore::QEntity(parent)),
      blended_(blended),
      material_(new ShaderMaterial(QStringLiteral("tile"), root_)),
      line_(new ShaderMaterial(QStringLiteral("ribbon"), root_)) {
    material_->bothSides();
    line_->set(QStringLiteral("lineColour"), tileLineColour);
    line_->set(QStringLiteral("widthPx"), 4.0F);
    line_->blend();
    line_->alwaysVisible();
    line_->bothSides();
}

ElementTiles::~ElementTiles() { delete root_; }

void ElementTiles::show(std::vector<Tile> tiles) {
    if (tiles.empty() && tiles_.empty()) return;
    highlight({});
    tiles_ = std::move(tiles);
    delete std::exchange(faces_, nullptr);
    if (!tiles_.empty()) faces_ = makeArrayEntity(makeTileGeometry(tiles_), *material_, root_);
}

void ElementTiles::highlight(const std::vector<std::size_t>& tiles) {
    delete std::exchange(outlines_, nullptr);
    highlighted_.clear();
    std::vector<GroundLine> lines;
    for (const std::size_t tile : tiles) {
        if (tile >= tiles_.size()) continue;
        highlighted_.push_back(tile);
        lines.push_back({{tiles_[tile].corners.begin(), tiles_[tile].corners.end()}, true});
    }
    if (!lines.empty()) outlines_ = makeArrayEntity(makeOutlineGeometry(lines), *line_, root_, blended_);
}

std::optional<std::size_t> ElementTiles::tileAt(const ViewRay& ray, double withinM) const {
    std::optional<std::size_t> nearest;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
        const double distance = distanceTo(tiles_[tile], ray);
        if (distance > withinM) continue;
        withinM = distance;
        nearest = tile;
    }
    return nearest;
}

void ElementTiles::setLens(const ViewLens& lens) {
    line_->set(QStringLiteral("viewSize"), QVector2D(float(lens.widthPx), float(lens.heightPx)));
}

}  // namespace noonmark
