#pragma once

#include <vector>

#include "core/engines/accrual/sun_depth_map.h"

class QVariant;

namespace Qt3DCore {
class QNode;
}

namespace noonmark {

class ShaderMaterial;

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
    void layTexture(const SunDepthMap& map);

    std::vector<ShaderMaterial*> materials_;
    Qt3DCore::QNode* parent_;
    Qt3DCore::QNode* texture_ = nullptr;
    bool shown_ = false;
};

}  // namespace noonmark
