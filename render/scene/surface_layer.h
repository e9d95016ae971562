#pragma once

#include <vector>

#include "render/scene/ground_picture.h"
#include "render/scene/surface_picture.h"

class QVariant;

namespace Qt3DCore {
class QNode;
}

namespace noonmark {

class ShaderMaterial;

/// Passes a SurfacePicture to the shaders of ground and buildings (resources/shaders/explored.inc).
class SurfaceLayer {
public:
    /// All arguments outlive this object; textures become children of `parent`.
    SurfaceLayer(std::vector<ShaderMaterial*> materials, Qt3DCore::QNode* parent);

    void setPalette(const std::vector<GroundPicture::Pixel>& colours);  ///< for shares 0 to 1
    void show(const SurfacePicture& picture);
    void clear();

private:
    void set(const char* uniform, const QVariant& value);

    std::vector<ShaderMaterial*> materials_;
    Qt3DCore::QNode* parent_;
    Qt3DCore::QNode* samples_ = nullptr;
    Qt3DCore::QNode* palette_ = nullptr;
};

}  // namespace noonmark
