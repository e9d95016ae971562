#pragma once

#include <QVector2D>
#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/city/meshes/mesh.h"
#include "render/view/section_box.h"

namespace Qt3DCore {
class QEntity;
}
namespace Qt3DRender {
class QAbstractTexture;
class QLayer;
}  // namespace Qt3DRender

namespace noonmark {

class ShaderMaterial;

/// Small marks at points, of the same size at any distance and in front of everything: the corners of an
/// outline that is edited, and the point that the cursor snaps to.
class PointMarks {
public:
    enum class Shape {
        corner,          ///< a square
        selectedCorner,  ///< a filled square
        middle,          ///< of an edge: a small disc
        snappedCorner,   ///< a large square
        snappedEdge,     ///< a cross
    };
    struct Mark {
        Shape shape = Shape::corner;
        glm::dvec3 at{0};
        bool operator==(const Mark&) const = default;
    };
    static constexpr double sizePx = 18;  ///< of the largest mark, device-independent pixels

    /// `parent` owns the nodes of this object; `overlay` and `blended` are the layers that the view draws
    /// last.
    PointMarks(Qt3DRender::QLayer* overlay, Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent);
    ~PointMarks();
    PointMarks(const PointMarks&) = delete;
    PointMarks& operator=(const PointMarks&) = delete;

    void show(std::vector<Mark> marks);
    [[nodiscard]] const std::vector<Mark>& shown() const { return marks_; }
    /// One mark more, over those of show().
    void showSnap(std::optional<Mark> snap);
    [[nodiscard]] const std::optional<Mark>& snap() const { return snap_; }

    void setViewSize(const QVector2D& size);  ///< of the view, device-independent pixels

private:
    void draw();

    Qt3DCore::QEntity* root_;
    Qt3DRender::QLayer* blended_;
    ShaderMaterial* material_;
    Qt3DRender::QAbstractTexture* shapes_ = nullptr;
    Qt3DCore::QEntity* entity_ = nullptr;
    std::vector<Mark> marks_;
    std::optional<Mark> snap_;
};

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
