#pragma once

#include <QHash>
#include <QString>
#include <glm/vec4.hpp>
#include <vector>

#include "core/engines/depths/sun_depth_map.h"
#include "core/engines/ray/visible_surface.h"
#include "render/scene/ground_picture.h"

class QVariant;

namespace Qt3DCore {
class QNode;
}

namespace noonmark {

/// The surfaces that a camera saw, with a value per pixel, drawn onto the surfaces themselves. The picture
/// stays in place while the view moves; it does not cover what this camera did not see.
struct SurfacePicture {
    PixelCamera camera;
    /// One per pixel of the camera, row 0 the TOP: position in local metres and share of the palette, 0 to 1;
    /// below 0: unknown.
    std::vector<glm::vec4> samples;
    bool soFar = false;  ///< covers only a part of the period: shown with stripes
};

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

/// Sun and shadow of one moment on all surfaces of some materials. It stays while the camera moves.
class SunLayer {
public:
    /// `parent` owns the nodes of this object; the shaders of `materials` include sunlit.inc.
    SunLayer(std::vector<ShaderMaterial*> materials, Qt3DCore::QNode* parent);

    void show(const SunDepthMap& map);
    void clear();
    [[nodiscard]] bool shown() const { return shown_; }

private:
    void set(const char* uniform, const QVariant& value);
    void layDepths(const QString& uniform, const std::vector<float>& depths, int size);
    void layCrowns(const QString& uniform, const std::vector<float>& depths, int size);

    std::vector<ShaderMaterial*> materials_;
    Qt3DCore::QNode* parent_;
    QHash<QString, Qt3DCore::QNode*> textures_;  ///< by uniform
    bool shown_ = false;
};

}  // namespace noonmark
