#pragma once

#include <QColor>
#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "core/city/city.h"
#include "core/city/meshes/mesh.h"
#include "render/scene/array_entity.h"
#include "render/scene/city_arrays.h"
#include "render/scene/ground_lines.h"
#include "render/view/camera_pose.h"

namespace Qt3DCore {
class QEntity;
}
namespace Qt3DRender {
class QLayer;
}

namespace noonmark {

class ArrayGeometry;
class ShaderMaterial;

/// Faces and edges of many buildings in one array each. Single buildings can be hidden and shown without
/// uploading the others again.
class BuildingBodies {
public:
    struct Materials {
        ShaderMaterial& faces;
        ShaderMaterial& cut;  ///< of the faces from behind, hidden at first
        ShaderMaterial& edges;
    };
    struct Layers {
        Qt3DRender::QLayer* blended;  ///< of the edges: drawn after all faces
        Qt3DRender::QLayer* side;     ///< of everything
    };
    /// `arrays` is not null; all arguments outlive this object. Empty arrays are not drawn.
    BuildingBodies(std::shared_ptr<const CityArrays> arrays, const Materials& materials, const Layers& layers,
                   Qt3DCore::QEntity* parent);
    ~BuildingBodies();
    BuildingBodies(const BuildingBodies&) = delete;
    BuildingBodies& operator=(const BuildingBodies&) = delete;

    [[nodiscard]] const std::shared_ptr<const CityArrays>& arrays() const { return arrays_; }

    /// Hides exactly these buildings: ascending indices into CityArrays::buildings. Costs only what changes.
    void leaveOut(const std::vector<std::uint32_t>& buildings);

    void showFaces(bool shown);
    void showEdges(bool shown);
    void showCut(bool shown);  ///< the faces from behind, which are seen where something cuts buildings open

private:
    void set(std::uint32_t building, bool shown);

    std::shared_ptr<const CityArrays> arrays_;
    std::vector<std::uint32_t> leftOut_;
    Qt3DCore::QEntity* faces_ = nullptr;
    Qt3DCore::QEntity* cut_ = nullptr;  ///< shares the geometry of faces_
    Qt3DCore::QEntity* edges_ = nullptr;
    ArrayGeometry* faceArray_ = nullptr;
    ArrayGeometry* edgeArray_ = nullptr;
};

/// The colour of what is proposed, while it is edited and afterwards.
inline constexpr QColor proposalColour{0x4f, 0xc2, 0xa4};

/// What the user is editing or asking about, drawn over the city: tinted buildings, a proposed building,
/// lines, a drag handle and a pin. Each can be replaced on its own many times a second; the city's arrays do
/// not change.
class OverlayBodies {
public:
    enum class Tint { hovered, selected, proposed };
    static constexpr double handlePx = 48;  ///< height of the handle on the screen, device-independent pixels

    /// `parent` owns the nodes of this object. Translucent faces, edges and lines also belong to `blended`,
    /// buildings, floors and handle to `side`, a recursive layer: of the side that shows the edited city.
    OverlayBodies(Qt3DRender::QLayer* blended, Qt3DRender::QLayer* side, Qt3DCore::QEntity* parent);
    ~OverlayBodies();
    OverlayBodies(const OverlayBodies&) = delete;
    OverlayBodies& operator=(const OverlayBodies&) = delete;

    /// Shows the buildings of `some`, or none if it is empty. About 0.1 ms per building.
    void show(Tint tint, const City& some);
    /// Buildings in one colour: red, green and blue, each 0 to 1.
    struct Coloured {
        glm::vec3 colour{0};
        City some;
    };
    /// What buildings are coloured by: of the two, a result lies over the sources of heights.
    enum class ColouredBy { heightSource, result };
    /// Shows buildings in colours, behind the tints; replaces those before of the same kind. About 0.1 ms per
    /// building.
    void showColoured(const std::vector<Coloured>& groups, ColouredBy by = ColouredBy::result);
    [[nodiscard]] std::size_t colouredCount(ColouredBy by = ColouredBy::result) const {
        return coloured_[std::size_t(by)].count;  // buildings
    }
    void showLines(const std::vector<GroundLine>& lines);
    /// Shows closed rings as thin lines, hidden behind nearer faces: the floors of storeys.
    void showFloors(const std::vector<std::vector<glm::vec3>>& rings);
    /// Shows a vertical double arrow at this point, with a constant size in pixels.
    void showHandle(std::optional<glm::dvec3> foot);
    void lightHandle(bool lit);  ///< under the cursor
    /// Whether what only helps to edit is drawn: the tints of what is hovered and selected, and the handle.
    void showEditing(bool shown);
    /// Shows a pin whose tip is at this point, with a constant size in pixels and in front of everything.
    void showPin(std::optional<glm::dvec3> tip);
    [[nodiscard]] const std::optional<glm::dvec3>& pin() const { return pin_.at; }
    /// Shows a smaller pin in another colour: the spot with the most new shadow of what is edited.
    void showWorstSpot(std::optional<glm::dvec3> tip);
    [[nodiscard]] const std::optional<glm::dvec3>& worstSpot() const { return worst_.at; }

    /// The pixel of the handle's centre; empty without a handle, or where it is behind the eye.
    [[nodiscard]] std::optional<glm::dvec2> handlePixel(const CameraPose& pose, const ViewLens& lens) const;

    void setLens(const CameraPose& pose, const ViewLens& lens);  ///< device-independent pixels

    /// The layer of all these nodes, which the view draws last.
    [[nodiscard]] Qt3DRender::QLayer* layer() const { return layer_; }

private:
    struct Body {
        ShaderMaterial* material = nullptr;
        Qt3DCore::QEntity* faces = nullptr;
        Qt3DCore::QEntity* edges = nullptr;
    };
    /// A solid of a constant size in pixels.
    struct Mark {
        TriangleMesh shape;  ///< pixels
        ShaderMaterial* material = nullptr;
        Qt3DCore::QEntity* entity = nullptr;
        std::optional<glm::dvec3> at;
    };
    [[nodiscard]] ShaderMaterial* makeTint(glm::vec4 colour, float lift);
    Body& of(Tint tint) { return bodies_[std::size_t(tint)]; }
    void show(Mark& mark, std::optional<glm::dvec3> at, Qt3DCore::QEntity* parent);

    Qt3DCore::QEntity* root_;
    Qt3DCore::QEntity* edited_;  ///< below root_: what belongs to the side
    Qt3DRender::QLayer* layer_;
    Qt3DRender::QLayer* blended_;
    std::array<Body, 3> bodies_;
    struct ColouredBodies {
        std::vector<Body> bodies;
        std::size_t count = 0;
    };
    std::array<ColouredBodies, 2> coloured_;
    ShaderMaterial* edge_;
    std::unique_ptr<GroundLines> lots_;
    ShaderMaterial* floor_;
    Qt3DCore::QEntity* floors_ = nullptr;
    Mark handle_, pin_, worst_;
};

}  // namespace noonmark
