#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "core/city/meshes/mesh.h"
#include "render/view/section_box.h"

namespace Qt3DCore {
class QEntity;
}
namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

class ShaderMaterial;

/// The outline of a section box and a handle on each of its sides, of a constant size in pixels.
class SectionMarks {
public:
    static constexpr double handlePx = 18;  ///< diameter, device-independent pixels

    /// The nodes belong to `overlay`, which is drawn last; lines also to `blended`. `parent` owns them.
    SectionMarks(Qt3DRender::QLayer* overlay, Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent);
    ~SectionMarks();
    SectionMarks(const SectionMarks&) = delete;
    SectionMarks& operator=(const SectionMarks&) = delete;

    void show(const std::optional<SectionBox>& box);  ///< empty: hides them
    /// The handle under the cursor is drawn lighter.
    void light(std::optional<std::size_t> side);
    void setLens(const CameraPose& pose, const ViewLens& lens);  ///< device-independent pixels

private:
    struct Handle {
        ShaderMaterial* material = nullptr;
        Qt3DCore::QEntity* entity = nullptr;
    };
    void showHandle(std::size_t side, const SectionBox& box);

    Qt3DCore::QEntity* root_;
    Qt3DRender::QLayer* blended_;
    ShaderMaterial* line_;
    Qt3DCore::QEntity* lines_ = nullptr;
    TriangleMesh shape_;
    std::array<Handle, 6> handles_;
    std::optional<std::size_t> lit_;
};

}  // namespace noonmark
