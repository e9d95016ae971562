#include "core/engines/depths/caster_faces.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

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
    if (city.terrain) append(all, makeCasterFaces(meshOf(*city.terrain)));
    return all;
}

CasterFaces makeCasterFaces(const TriangleMesh& closed) {
    FaceList list;
    list.addTriangles(closed, false);
    return list.take();
}

namespace {

constexpr std::uint32_t unused = ~std::uint32_t{0};

/// Culls face by face and compacts the points of the remaining faces.
class Culling {
public:
    Culling(const CasterFaces& faces, const std::vector<glm::dvec3>& placed, const MapFrame& frame,
            const SunInterval& interval, CasterSide side, const ReceiverExtent& receivers)
        : faces_(faces),
          placed_(placed),
          frame_(frame),
          shears_{frame.shearOf(interval.first), frame.shearOf(interval.last)},
          side_(side),
          receivers_(receivers),
          newIndex_(faces.points.size(), unused) {}

    IntervalCasters run() {
        for (const CasterFace& face : faces_.faces) {
            if (!isDrawn(face))
                ++result_.turnedOther;
            else if (!reaches(face))
                ++result_.outOfReach;
            else
                keep(face);
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] glm::dvec2 thrown(std::uint32_t point, glm::dvec2 shear) const {
        const glm::dvec3 p = placed_[point];
        return {p.x - p.z * shear.x, p.y - p.z * shear.y};
    }

    [[nodiscard]] double turn(const CasterFace& face, glm::dvec2 shear) const {
        const glm::dvec2 a = thrown(face.corner[0], shear), b = thrown(face.corner[1], shear),
                         c = thrown(face.corner[2], shear);
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }

    // A face that is turned the same way at both ends is so in between, because the sun's direction at every
    // step is a linear combination of the two.
    [[nodiscard]] bool isDrawn(const CasterFace& face) const {
        double top = placed_[face.corner[0]].z;
        for (std::size_t i = 1; i < face.corners; ++i) top = std::max(top, placed_[face.corner[i]].z);
        if (top <= receivers_.lowestW) return false;
        if (face.twoSided) return true;
        const double first = turn(face, shears_[0]), last = turn(face, shears_[1]);
        constexpr double edgeOn = 1e-9;  // square metres
        return side_ == CasterSide::towardsSun ? std::max(first, last) > -edgeOn
                                               : std::min(first, last) < edgeOn;
    }

    [[nodiscard]] bool reaches(const CasterFace& face) const {
        glm::dvec2 low(1e30), high(-1e30);
        for (std::size_t i = 0; i < face.corners; ++i)
            for (const glm::dvec2 shear : shears_) {
                const glm::dvec2 at = thrown(face.corner[i], shear);
                low = glm::min(low, at);
                high = glm::max(high, at);
            }
        return meetsMap(low, high) && (!receivers_.any || receivers_.any(low, high));
    }

    // Straight lines stay straight under the warp, so a box whose corners all lie outside the same border of
    // the map does not meet the map.
    [[nodiscard]] bool meetsMap(glm::dvec2 low, glm::dvec2 high) const {
        int west = 0, east = 0, south = 0, north = 0, behind = 0;
        for (const glm::dvec2 corner : {low, glm::dvec2(high.x, low.y), high, glm::dvec2(low.x, high.y)}) {
            const glm::dvec3 h = frame_.homogeneous({corner.x, corner.y, 0}, {});
            west += h.x<-h.z, east += h.x> frame_.columns * h.z;
            south += h.y<-h.z, north += h.y> frame_.rows * h.z;
            behind += h.z < MapFrame::minQ;
        }
        return west < 4 && east < 4 && south < 4 && north < 4 && behind < 4;
    }

    void keep(CasterFace face) {
        for (std::size_t i = 0; i < face.corners; ++i) {
            std::uint32_t& index = newIndex_[face.corner[i]];
            if (index == unused) {
                index = std::uint32_t(result_.points.size());
                result_.points.push_back(placed_[face.corner[i]]);
            }
            face.corner[i] = index;
        }
        result_.faces.push_back(face);
    }

    const CasterFaces& faces_;
    const std::vector<glm::dvec3>& placed_;
    const MapFrame& frame_;
    glm::dvec2 shears_[2];
    CasterSide side_;
    const ReceiverExtent& receivers_;
    std::vector<std::uint32_t> newIndex_;
    IntervalCasters result_;
};

}  // namespace

IntervalCasters placeCasters(const CasterFaces& faces, const std::vector<glm::dvec3>& placed,
                             const MapFrame& frame, const SunInterval& interval, CasterSide side,
                             const ReceiverExtent& receivers) {
    return Culling(faces, placed, frame, interval, side, receivers).run();
}

}  // namespace noonmark
