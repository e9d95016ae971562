#pragma once

// The folder render/view/ shows a city on the screen. city_view.h is the Qt3D window, view_navigator.h moves
// its camera with mouse and keys, camera_pose.h and camera_control.h are the camera as a value and its
// movements, view_ray.h and scene_picker.h find what lies under a pixel, and explored_view.h holds shadow on
// the surfaces that a camera sees.

#include <QImage>
#include <Qt3DExtras/Qt3DWindow>
#include <functional>
#include <memory>

#include "render/scene/building_bodies.h"
#include "render/scene/element_tiles.h"
#include "render/scene/ground_picture.h"
#include "render/scene/overlay_bodies.h"
#include "render/scene/place_marks.h"
#include "render/scene/section_marks.h"
#include "render/scene/sun_layer.h"
#include "render/scene/surface_layer.h"
#include "render/view/view_ray.h"

class QTimer;

namespace Qt3DRender {
class QFrameGraphNode;
class QLayer;
class QLayerFilter;
class QParameter;
class QRenderCapture;
class QRenderStateSet;
class QTechniqueFilter;
}  // namespace Qt3DRender

namespace noonmark {

class ShaderMaterial;

/// The city on the screen: buildings, ground and lines over it. Draws only after a change. Embed it with
/// QWidget::createWindowContainer. Requires the OpenGL renderer of Qt3D: set QT3D_RENDERER=opengl before
/// creating the application.
class CityView final : public Qt3DExtras::Qt3DWindow {
    Q_OBJECT
public:
    CityView();
    ~CityView() override;

    /// Replaces the city (not null), removes pictures and lines, and shows the whole city.
    void showCity(std::shared_ptr<const CityArrays> arrays);
    /// Shows the differences from the arrays of showCity(), replacing earlier differences; camera, pictures
    /// and lines stay. Costs only what changed.
    void showChanges(const ArrayDifference& changes);
    /// The arrays of showCity(); null before its first call.
    [[nodiscard]] std::shared_ptr<const CityArrays> arrays() const;
    [[nodiscard]] OverlayBodies& overlay() { return *overlay_; }
    /// Outlines and names of places. Names are chosen again when the camera rests.
    [[nodiscard]] PlaceMarks& places() { return *places_; }
    /// Shows a picture on the ground. `soFar`: it covers only a part of the period or region and is striped.
    void showPicture(const GroundPicture& picture, bool soFar = false);
    /// Shows a picture on the roofs, in addition to showPicture(). clearPicture() and the next showPicture()
    /// remove it.
    void showRoofPicture(const GroundPicture& picture);
    void clearPicture();
    /// Shows a map on the ground, below the other pictures; it stays until the next one or clearMap().
    void showMap(const GroundPicture& picture);
    void clearMap();
    /// Pictures on ground, roofs and facades; they cover the picture on the ground.
    [[nodiscard]] SurfaceLayer& surfaces() { return *surfaces_; }
    /// What was measured at points of facades and planes.
    [[nodiscard]] ElementTiles& tiles() { return *tiles_; }
    /// Sun and shadow of one moment on ground, roofs and facades.
    [[nodiscard]] SunLayer& sun() { return *sun_; }
    /// Shows or hides the faces; without them only the buildings' edges cover the ground.
    void showFaces(bool shown);
    void showLines(const std::vector<GroundLine>& lines);
    /// Cuts away what lies outside the box; empty: shows everything. Shadows and pictures stay those of the
    /// whole city. It stays when the city changes.
    void showSection(const std::optional<SectionBox>& box);
    [[nodiscard]] const std::optional<SectionBox>& section() const { return section_; }
    [[nodiscard]] SectionMarks& sectionMarks() { return *sectionMarks_; }

    [[nodiscard]] const CameraPose& pose() const { return pose_; }
    void setPose(const CameraPose& pose);
    [[nodiscard]] const ViewBounds& viewBounds() const { return bounds_; }
    [[nodiscard]] ViewLens lens() const;

    /// Captures the next frame in device pixels; calls back in this thread.
    void capture(std::function<void(QImage)> done);

Q_SIGNALS:
    void poseChanged();  ///< also emitted when the size of the view changes
    void sectionChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void exposeEvent(QExposeEvent* event) override;

private:
    void makeFrameGraph();
    Qt3DRender::QFrameGraphNode* passes(const char* pass, Qt3DRender::QFrameGraphNode* parent);
    Qt3DRender::QLayerFilter* drawn(bool overlay, bool blended, Qt3DRender::QFrameGraphNode* parent);
    void makeMaterials();
    void showCut();
    void makeClipping(Qt3DRender::QTechniqueFilter& forward, Qt3DRender::QFrameGraphNode* parent);
    void applyCamera();
    void showEdges(bool shown);
    void showGround(const CityArrays& arrays);
    Qt3DCore::QEntity* add(Qt3DRender::QGeometryRenderer* geometry, ShaderMaterial* material,
                           Qt3DRender::QLayer* layer = nullptr);

    CameraPose pose_;
    ViewBounds bounds_;
    Qt3DCore::QEntity* root_;
    Qt3DRender::QLayer* blended_;  ///< edges, lines and translucent faces
    Qt3DCore::QEntity* groundEntity_ = nullptr;
    std::unique_ptr<BuildingBodies> city_;
    std::unique_ptr<BuildingBodies> added_;
    bool manyEdges_ = false;
    bool exposed_ = false;
    QTimer* rest_;
    QTimer* names_;
    Qt3DCore::QEntity* lines_ = nullptr;
    bool facesShown_ = true;
    ShaderMaterial* building_ = nullptr;
    ShaderMaterial* cut_ = nullptr;  ///< buildings from behind
    ShaderMaterial* edge_ = nullptr;
    ShaderMaterial* ground_ = nullptr;
    ShaderMaterial* ribbon_ = nullptr;
    Qt3DCore::QNode* texture_ = nullptr;
    Qt3DCore::QNode* roofTexture_ = nullptr;
    Qt3DCore::QNode* mapTexture_ = nullptr;
    std::unique_ptr<SurfaceLayer> surfaces_;
    std::unique_ptr<SunLayer> sun_;
    std::unique_ptr<ElementTiles> tiles_;
    std::unique_ptr<OverlayBodies> overlay_;
    std::unique_ptr<PlaceMarks> places_;
    std::optional<SectionBox> section_;
    Qt3DRender::QRenderStateSet* clipping_ = nullptr;
    Qt3DRender::QParameter* sectionLow_ = nullptr;
    Qt3DRender::QParameter* sectionHigh_ = nullptr;
    std::unique_ptr<SectionMarks> sectionMarks_;
    Qt3DRender::QRenderCapture* capture_ = nullptr;
};

}  // namespace noonmark
