#include "core/engines/accrual/caster_faces.h"

#include <tbb/parallel_for.h>

#include "core/city/meshes/mesh_topology.h"

namespace noonmark {

namespace {

// An extruded wall is two consecutive triangles that share the edge from the first corner to the third.
bool makesWall(glm::uvec3 first, glm::uvec3 second) { return first.x == second.x && first.z == second.y; }

class FaceList {
public:
    void addPart(const Part& part) {
        if (part.mesh)
            addTriangles(*part.mesh, findOpenEdges(*part.mesh) > 0);
        else
            addPrism(meshOf(part));
    }

    void addTriangles(const TriangleMesh& mesh, bool twoSided) {
        const std::uint32_t first = addPoints(mesh);
        for (const glm::uvec3 t : mesh.triangles) addTriangle(t + first, twoSided);
    }

    CasterFaces take() { return std::move(list_); }

private:
    void addPrism(const TriangleMesh& mesh) {
        const std::uint32_t first = addPoints(mesh);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3 t = mesh.triangles[i] + first;
            const bool wall = i + 1 < mesh.triangles.size() &&
                              makesWall(mesh.triangles[i], mesh.triangles[i + 1]) &&
                              mesh.vertices[mesh.triangles[i].z].z != mesh.vertices[mesh.triangles[i].x].z;
            if (wall)
                list_.faces.push_back({{t.x, t.y, t.z, mesh.triangles[++i].z + first}, 4, false});
            else
                addTriangle(t, false);
        }
    }

    std::uint32_t addPoints(const TriangleMesh& mesh) {
        const auto first = std::uint32_t(list_.points.size());
        list_.points.insert(list_.points.end(), mesh.vertices.begin(), mesh.vertices.end());
        return first;
    }

    void addTriangle(glm::uvec3 t, bool twoSided) {
        list_.faces.push_back({{t.x, t.y, t.z, 0}, 3, twoSided});
    }

    CasterFaces list_;
};

void append(CasterFaces& all, const CasterFaces& some) {
    const auto first = std::uint32_t(all.points.size());
    all.points.insert(all.points.end(), some.points.begin(), some.points.end());
    for (CasterFace face : some.faces) {
        for (std::uint32_t& corner : face.corner) corner += first;
        all.faces.push_back(face);
    }
}

}  // namespace

CasterFaces makeCasterFaces(const City& city, std::span<const std::uint32_t> buildings,
                            const std::stop_token& stop) {
    std::vector<CasterFaces> each(buildings.size());
    tbb::parallel_for(std::size_t{0}, buildings.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        FaceList list;
        for (const Part& part : city.buildings[buildings[i]]->parts) list.addPart(part);
        each[i] = list.take();
    });
    CasterFaces all;
    for (const CasterFaces& some : each) append(all, some);
    if (!city.terrain) return all;
    FaceList ground;
    ground.addTriangles(meshOf(*city.terrain), false);
    append(all, ground.take());
    return all;
}

}  // namespace noonmark
