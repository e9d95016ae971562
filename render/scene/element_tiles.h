#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "render/view/camera_pose.h"

namespace Qt3DCore {
class QEntity;
}
namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

class ShaderMaterial;

/// Coloured rectangles on walls, or on a level plane: one for each point that was measured. Their colours are
/// shown as they are in the legend, without light or haze.
class ElementTiles {
public:
    struct Tile {
        std::array<glm::vec3, 4> corners;  ///< local metres, counterclockwise seen from in front
        glm::vec3 colour;                  ///< red, green, blue, each 0 to 1
    };

    /// `parent` owns the nodes of this object. The outlines of highlighted tiles belong to `blended`.
    ElementTiles(Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent);
    ~ElementTiles();
    ElementTiles(const ElementTiles&) = delete;
    ElementTiles& operator=(const ElementTiles&) = delete;

    void show(std::vector<Tile> tiles);  ///< replaces all tiles; highlights are removed. Some 50 ns a tile
    void clear() { show({}); }
    void highlight(const std::vector<std::size_t>& tiles);  ///< outlines these, in front of everything
    [[nodiscard]] const std::vector<Tile>& tiles() const { return tiles_; }
    [[nodiscard]] const std::vector<std::size_t>& highlighted() const { return highlighted_; }

    /// The first tile that the ray meets within a distance in metres, from either side. O(tiles).
    [[nodiscard]] std::optional<std::size_t> tileAt(const ViewRay& ray, double withinM) const;

    void setLens(const ViewLens& lens);  ///< device-independent pixels

private:
    Qt3DCore::QEntity* root_;
    Qt3DRender::QLayer* blended_;
    ShaderMaterial* material_;
    ShaderMaterial* line_;
    std::vector<Tile> tiles_;
    std::vector<std::size_t> highlighted_;
    Qt3DCore::QEntity* faces_ = nullptr;
    Qt3DCore::QEntity* outlines_ = nullptr;
};

}  // namespace noonmark
