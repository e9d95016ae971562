#pragma once

#include <Qt3DCore/QEntity>
#include <memory>
#include <optional>
#include <vector>

#include "core/engines/ray/traced_view.h"
#include "render/scene/crown_bodies.h"
#include "render/view/section_box.h"
#include "render/view/view_sides.h"

namespace Qt3DRender {
class QAbstractTexture;
class QLayer;
}  // namespace Qt3DRender

namespace noonmark {

/// Whether OpenGL draws on the processor (llvmpipe, softpipe, SwiftShader), where each pixel and each core
/// counts. Asks once, with a context of its own: about 50 ms. False without OpenGL. Needs a QGuiApplication.
bool drawsInSoftware();

class ShaderMaterial;
struct CoarsePicture;

/// Buildings and ground drawn by rays, for processors without graphics hardware: software OpenGL takes 0.2 to
/// 0.5 s for the triangles of a large city, rays take 20 ms to find what each pixel shows. Shaders colour the
/// pixels as they colour triangles; depths are written, so that everything else is drawn as before.
class TracedCity {
public:
    using Buildings = std::vector<std::shared_ptr<const Building>>;

    /// `parent` owns the nodes, which belong to the layer `side`.
    TracedCity(Qt3DRender::QLayer* side, Qt3DCore::QEntity* parent);

    /// The ground that is no part of the scene.
    struct Ground {
        float levelM = 0;                          ///< z of the plane around and below the city
        std::shared_ptr<const Terrain> terrain{};  ///< null: the plane is all there is
    };
    /// What is traced: a scene, its buildings in the scene's order, and the ground around. Proposals
    /// (isProposal()) have a colour of their own.
    void setScene(RayScene scene, Buildings buildings, Ground ground);
    void clear();
    [[nodiscard]] bool hasScene() const { return scene_.has_value(); }
    /// Leaves out the other buildings. Returns whether the scene has all of these.
    bool showOnly(std::vector<const Building*> shown);

    void show(bool shown);
    /// How its picture gets fewer pixels: its nodes in `layer` are drawn into `picture`, from which others
    /// copy it. Needed before the first picture with Picture::isCoarse.
    void setCoarse(Qt3DRender::QLayer* layer, const CoarsePicture& picture);
    /// The trees of the city; null: none.
    void setCrowns(std::shared_ptr<const CrownRays> crowns) { crowns_ = std::move(crowns); }
    [[nodiscard]] bool hasCrowns() const { return crowns_ != nullptr; }
    /// The sun of a moment, a unit vector; empty: none. trace() draws its shadows.
    void setSun(const std::optional<glm::vec3>& towardsSun);
    struct Picture {
        CameraPose pose;
        ViewLens lens;  ///< in device pixels
        ClipRange clip;
        std::optional<SectionBox> section;
        SideColumns columns;    ///< of the picture that are wanted
        int leftPx = 0;         ///< column of the window where the picture begins
        int spacingPx = 1;      ///< pixels a side that share one ray; not 1: all columns are wanted
        bool isCoarse = false;  ///< such pixels share their colour, too
        int treeDay = 0;        ///< day of the year whose leaves trees have; 0: trees are not drawn
    };
    /// Traces a picture, on all cores.
    void trace(const Picture& picture);

    /// Colours buildings and ground.
    [[nodiscard]] ShaderMaterial* material() const { return material_; }

private:
    void set(const char* uniform, const QVariant& value);
    void layTexture();
    void showPixels();

    Qt3DCore::QEntity* parent_;
    Qt3DRender::QLayer* side_;
    ShaderMaterial* material_;
    Qt3DCore::QEntity* pixels_;                  ///< one triangle over the picture
    ShaderMaterial* copyMaterial_ = nullptr;     ///< see setCoarse()
    Qt3DCore::QEntity* coarsePixels_ = nullptr;  ///< likewise, drawn into the coarse picture
    Qt3DCore::QEntity* copy_ = nullptr;          ///< of that
    bool shown_ = false, isCoarse_ = false;
    Qt3DRender::QAbstractTexture* texture_ = nullptr;
    TracedView view_;
    std::optional<RayScene> scene_;
    std::shared_ptr<const CrownRays> crowns_;
    Buildings buildings_;
    std::vector<std::uint8_t> hidden_, proposed_;  ///< by building, 1: left out; empty: nothing is
    std::optional<glm::vec3> towardsSun_;
    Ground ground_;
};

}  // namespace noonmark
