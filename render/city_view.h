#pragma once

#include <QImage>
#include <Qt3DExtras/Qt3DWindow>
#include <functional>
#include <memory>

#include "render/city_arrays.h"
#include "render/ground_picture.h"
#include "render/outline_geometry.h"
#include "render/surface_layer.h"
#include "render/view_ray.h"

class QTimer;

namespace Qt3DRender {
class QRenderCapture;
}

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

    /// Replaces the city; pictures and lines go.
    void showCity(const CityArrays& arrays);
    /// On the ground. `soFar`: it shows a part of the period or region only, which stripes say.
    void showPicture(const GroundPicture& picture, bool soFar = false);
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

private:
    void makeFrameGraph();
    void makeMaterials();
    void applyCamera();
    void showEdges();
    Qt3DCore::QEntity* add(Qt3DRender::QGeometryRenderer* geometry, ShaderMaterial* material,
                           Qt3DCore::QEntity* parent);

    CameraPose pose_;
    ViewBounds bounds_;
    Qt3DCore::QEntity* root_;
    Qt3DCore::QEntity* city_ = nullptr;
    Qt3DCore::QEntity* faces_ = nullptr;
    Qt3DCore::QEntity* edges_ = nullptr;
    bool manyEdges_ = false;
    QTimer* rest_;
    Qt3DCore::QEntity* lines_ = nullptr;
    bool facesShown_ = true;
    ShaderMaterial* building_ = nullptr;
    ShaderMaterial* edge_ = nullptr;
    ShaderMaterial* ground_ = nullptr;
    ShaderMaterial* ribbon_ = nullptr;
    Qt3DCore::QNode* texture_ = nullptr;
    std::unique_ptr<SurfaceLayer> surfaces_;
    Qt3DRender::QRenderCapture* capture_ = nullptr;
};

}  // namespace noonmark
