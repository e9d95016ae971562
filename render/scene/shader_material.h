#pragma once

#include <QString>
#include <Qt3DRender/QMaterial>

namespace Qt3DRender {
class QRenderPass;
}

namespace noonmark {

/// The shaders `vertex`.vert and `fragment`.frag of resources/shaders, drawn by the window's own frame graph.
/// Values of uniforms are set by name.
class ShaderMaterial final : public Qt3DRender::QMaterial {
    Q_OBJECT
public:
    ShaderMaterial(const QString& vertex, const QString& fragment, Qt3DCore::QNode* parent);
    explicit ShaderMaterial(const QString& both, Qt3DCore::QNode* parent = nullptr)
        : ShaderMaterial(both, both, parent) {}

    void set(const QString& uniform, const QVariant& value);

    void blend();          ///< by alpha, without writing depth
    void alwaysVisible();  ///< drawn over what stands before it
    void bothSides();      ///< faces are not culled

private:
    Qt3DRender::QRenderPass* pass_;
};

}  // namespace noonmark
