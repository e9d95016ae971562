#pragma once

#include <memory>
#include <optional>

#include "render/scene/city_bodies.h"
#include "render/scene/crown_bodies.h"
#include "render/scene/ground_picture.h"
#include "render/scene/surface_layer.h"
#include "render/view/camera_pose.h"
#include "render/view/traced_city.h"

namespace noonmark {

class ShaderMaterial;

/// Buildings and ground of one city in the view, and the pictures on them: as triangles, or, where the
/// processor draws, by rays.
class DrawnCity {
public:
    /// `parent` owns the nodes. `blended`: of edges. `side`: of all nodes, the side of the view that shows
    /// this city.
    DrawnCity(Qt3DRender::QLayer* blended, Qt3DRender::QLayer* side, Qt3DCore::QEntity* parent);
    ~DrawnCity();

    /// Replaces the city (not null) and removes the pictures but for the map.
    void showCity(std::shared_ptr<const CityArrays> arrays);
    /// Shows the differences from the arrays of showCity(), replacing earlier differences. Costs only what
    /// changed.
    void showChanges(const ArrayDifference& changes);
    /// Removes the city.
    void clear();
    [[nodiscard]] std::shared_ptr<const CityArrays> arrays() const;  ///< null without a city
    /// The bounds of what is shown, the changes included.
    [[nodiscard]] const ViewBounds& bounds() const { return bounds_; }

    /// See CityView::setRays().
    void setRays(RayScene scene, const std::vector<std::shared_ptr<const Building>>& buildings);
    void clearRays();
    [[nodiscard]] bool isTraced() const { return traced_.hasScene() && facesShown_; }

    void showFaces(bool shown);
    [[nodiscard]] bool facesShown() const { return facesShown_; }
    /// Whether insides are drawn, where a section cuts buildings open.
    void showCut(bool shown);
    /// Many edges are hidden while the camera moves; false if they stay.
    bool hideEdges();
    void showEdges();

    /// See CityView.
    void showPicture(const GroundPicture& picture, bool soFar);
    void showRoofPicture(const GroundPicture& picture);
    void clearPicture();
    void showMap(const GroundPicture& picture);
    void clearMap();
    void showFinerMap(const GroundPicture& picture);
    void clearFinerMap();
    [[nodiscard]] SurfaceLayer& surfaces() { return *surfaces_; }
    [[nodiscard]] SunLayer& sun() { return *sun_; }
    /// Shows the city's trees, which stay until others are shown; null: none. `rays`: of these, which draw
    /// them and their shade where rays draw the city; null: triangles do, without shade.
    void showTrees(std::shared_ptr<const Trees> trees, std::shared_ptr<const CrownRays> rays);
    /// How they are drawn.
    [[nodiscard]] CrownBodies& crowns() { return crowns_; }
    [[nodiscard]] const CrownBodies& crowns() const { return crowns_; }
    /// The sun of a moment where rays draw: a unit vector; empty: none.
    void setTracedSun(const std::optional<glm::dvec3>& towardsSun);

    void setHaze(float distanceM);  ///< where what is far away fades into the background
    [[nodiscard]] TracedCity& traced() { return traced_; }
    /// Sets a uniform that no shader reads, so that a frame is drawn.
    void redraw();

private:
    using Materials = std::vector<ShaderMaterial*>;
    void showBodies();
    void showGround(const CityArrays& arrays);
    [[nodiscard]] std::unique_ptr<BuildingBodies> makeBodies(std::shared_ptr<const CityArrays> arrays,
                                                             ShaderMaterial& faces);

    Qt3DRender::QLayer* blended_;
    Qt3DRender::QLayer* side_;
    Qt3DCore::QEntity* parent_;
    ShaderMaterial* building_;
    ShaderMaterial* proposal_;  ///< what was added to the city drawn first, where all of it is a proposal
    ShaderMaterial* cut_;       ///< buildings from behind
    ShaderMaterial* edge_;
    ShaderMaterial* ground_;
    TracedCity traced_;
    CrownBodies crowns_;
    Materials bodyMaterials_, groundMaterials_;  ///< of triangles, and of what rays found
    std::unique_ptr<BuildingBodies> city_;
    std::unique_ptr<BuildingBodies> added_;
    Qt3DCore::QEntity* groundEntity_ = nullptr;
    Qt3DCore::QNode* texture_ = nullptr;
    Qt3DCore::QNode* roofTexture_ = nullptr;
    Qt3DCore::QNode* mapTexture_ = nullptr;
    Qt3DCore::QNode* finerMapTexture_ = nullptr;
    std::unique_ptr<SurfaceLayer> surfaces_;
    std::unique_ptr<SunLayer> sun_;
    ViewBounds bounds_;
    bool manyEdges_ = false;
    bool addedTraced_ = false;  ///< the rays' scene has all added buildings
    bool facesShown_ = true;
    bool cutShown_ = false;
    bool redrawn_ = false;
};

}  // namespace noonmark
