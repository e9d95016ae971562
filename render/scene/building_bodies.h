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

/// Faces and edges of many buildings in one array each. Single ones are left out and come back without the
/// others being sent to the graphics card again.
class BuildingBodies {
public:
    /// `arrays` not null; all outlive it. Nothing of an empty array is drawn. The edges lie in `blended`, the
    /// layer of what is drawn after all faces.
    BuildingBodies(std::shared_ptr<const CityArrays> arrays, ShaderMaterial& faces, ShaderMaterial& edges,
                   Qt3DRender::QLayer* blended, Qt3DCore::QEntity* parent);
    ~BuildingBodies();
    BuildingBodies(const BuildingBodies&) = delete;
    BuildingBodies& operator=(const BuildingBodies&) = delete;

    [[nodiscard]] const std::shared_ptr<const CityArrays>& arrays() const { return arrays_; }

    /// Exactly these are left out: indices in CityArrays::buildings, ascending. Cost: those that change.
    void leaveOut(const std::vector<std::uint32_t>& buildings);

    void showFaces(bool shown);
    void showEdges(bool shown);

private:
    void set(std::uint32_t building, bool shown);

    std::shared_ptr<const CityArrays> arrays_;
    std::vector<std::uint32_t> leftOut_;
    Qt3DCore::QEntity* faces_ = nullptr;
    Qt3DCore::QEntity* edges_ = nullptr;
    ArrayGeometry* faceArray_ = nullptr;
    ArrayGeometry* edgeArray_ = nullptr;
};

}  // namespace noonmark
