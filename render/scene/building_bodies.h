#pragma once

#include <memory>
#include <vector>

#include "render/scene/city_arrays.h"

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

}  // namespace noonmark
