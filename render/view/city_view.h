#pragma once

#include <QImage>
#include <Qt3DExtras/Qt3DWindow>
#include <functional>
#include <memory>

#include "render/scene/building_bodies.h"
#include "render/scene/ground_picture.h"
#include "render/scene/overlay_bodies.h"
#include "render/scene/surface_layer.h"
#include "render/view/view_ray.h"

class QTimer;

namespace Qt3DRender {
class QFrameGraphNode;
class QLayer;
class QLayerFilter;
class QRenderCapture;
}  // namespace Qt3DRender

namespace noonmark {

class ShaderMaterial;

/// The city on the screen: buildings, ground and lines over it. Draws only when something changed. Put it
/// into a window with QWidget::createWindowContainer. Works with the OpenGL renderer of Qt3D: set
/// QT3D_RENDERER=opengl before the application is made.
class CityView final : public Qt3DExtras::Qt3DWindow {
    Q_OBJECT
public:
    CityView();
    ~CityView() override;

    /// Replaces the city (not null); pictures and lines go, and all of it is in sight.
    void showCity(std::shared_ptr<const CityArrays> arrays);
    /// What is different from the city's arrays, in place of what was before; camera, pictures and lines
    /// stay. Cost: of what changed.
    void showChanges(const ArrayDifference& changes);
    /// The arrays of showCity; null before the first.
    [[nodiscard]] std::shared_ptr<const CityArrays> arrays() const;
    [[nodiscard]] OverlayBodies& overlay() { return *overlay_; }
    /// On the ground. `soFar`: it shows a part of the period or region only, which stripes say.
    void showPicture(const GroundPicture& picture, bool soFar = false);
    /// On what looks up of the buildings, with showPicture()'s on the ground; goes with clearPicture() and
    /// the next showPicture().
    void showRoofPicture(const GroundPicture& picture);
    void clearPicture();
    /// On ground, roofs and facades; over the ground's picture.
    [[nodiscard]] SurfaceLayer& surfaces() { return *surfaces_; }
    /// Faces can be left out, so that only their edges stand before the ground.
    void showFaces(bool shown);
    void showLines(const std::vector<GroundLine>& lines);

    [[nodiscard]] const CameraPose& pose() const { return pose_; }
    void setPose(const CameraPose& pose);
    [[nodiscard]] const ViewBounds& viewBounds() const { return bounds_; }
    [[nodiscard]] ViewLens lens() const;

    /// The next frame as an image, in device pixels; called back in this thread.
    void capture(std::function<void(QImage)> done);

Q_SIGNALS:
    void poseChanged();  ///< or the size of the picture

protected:
    void resizeEvent(QResizeEvent* event) override;
    void exposeEvent(QExposeEvent* event) override;

private:
    void makeFrameGraph();
    Qt3DRender::QLayerFilter* drawn(bool overlay, bool blended, Qt3DRender::QFrameGraphNode* parent);
    void makeMaterials();
    void applyCamera();
    void showEdges(bool shown);
    void showGround(const CityArrays& arrays);
    Qt3DCore::QEntity* add(Qt3DRender::QGeometryRenderer* geometry, ShaderMaterial* material,
                           Qt3DRender::QLayer* layer = nullptr);

    CameraPose pose_;
    ViewBounds bounds_;
    Qt3DCore::QEntity* root_;
    Qt3DRender::QLayer* blended_;  ///< edges, lines and what is seen through
    Qt3DCore::QEntity* groundEntity_ = nullptr;
    std::unique_ptr<BuildingBodies> city_;
    std::unique_ptr<BuildingBodies> added_;
    bool manyEdges_ = false;
    bool exposed_ = false;
    QTimer* rest_;
    Qt3DCore::QEntity* lines_ = nullptr;
    bool facesShown_ = true;
    ShaderMaterial* building_ = nullptr;
    ShaderMaterial* edge_ = nullptr;
    ShaderMaterial* ground_ = nullptr;
    ShaderMaterial* ribbon_ = nullptr;
    Qt3DCore::QNode* texture_ = nullptr;
    Qt3DCore::QNode* roofTexture_ = nullptr;
    std::unique_ptr<SurfaceLayer> surfaces_;
    std::unique_ptr<OverlayBodies> overlay_;
    Qt3DRender::QRenderCapture* capture_ = nullptr;
};

}  // namespace noonmark
