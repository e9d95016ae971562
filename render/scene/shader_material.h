#pragma once

#include <QHash>
#include <QString>
#include <QStringList>
#include <Qt3DRender/QMaterial>

namespace Qt3DRender {
class QRenderPass;
class QShaderProgram;
class QTechnique;
}  // namespace Qt3DRender

namespace noonmark {

/// A material of the shaders `vertex`.vert and `fragment`.frag in resources/shaders, drawn by the window's
/// own frame graph. Uniforms are set by name.
class ShaderMaterial final : public Qt3DRender::QMaterial {
    Q_OBJECT
public:
    ShaderMaterial(const QString& vertex, const QString& fragment, Qt3DCore::QNode* parent);
    explicit ShaderMaterial(const QString& both, Qt3DCore::QNode* parent = nullptr)
        : ShaderMaterial(both, both, parent) {}

    void set(const QString& uniform, const QVariant& value);
    /// Compiles the shaders with the code between `#ifdef part` and `#endif`, or without it. Software drawing
    /// executes every branch of a shader, so a part that nothing is shown of costs as much as one in use.
    void include(const QString& part, bool included);

    void blend();          ///< alpha blending, without writing depth
    void alwaysVisible();  ///< ignores depth: drawn over nearer objects
    void bothSides();      ///< disables culling
    void fromBehind();     ///< draws only what is seen from behind
    /// Draws depth alone before colour, so that hidden surfaces cost no colour: where the processor draws, a
    /// city has ten layers of buildings behind each other.
    void drawDepthFirst();

    /// Values of the key "pass", by which a frame graph draws first depths and then colours.
    static constexpr const char* depthPass = "depth";
    static constexpr const char* colourPass = "colour";

private:
    void cull(int mode);  ///< a QCullFace::CullingMode
    void usePrograms();

    QString vertex_, fragment_;
    QStringList parts_;                                     ///< sorted
    QHash<QString, Qt3DRender::QShaderProgram*> programs_;  ///< by fragment shader and parts
    Qt3DRender::QRenderPass* pass_;
    Qt3DRender::QRenderPass* depth_ = nullptr;
    Qt3DRender::QTechnique* technique_;
};

}  // namespace noonmark
