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

/// The SurfacePicture in the shaders of ground and buildings (resources/shaders/explored.inc).
class SurfaceLayer {
public:
    /// All outlive it; textures become children of `parent`.
    SurfaceLayer(std::vector<ShaderMaterial*> materials, Qt3DCore::QNode* parent);

    void setPalette(const std::vector<GroundPicture::Pixel>& colours);  ///< from share 0 to 1
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
