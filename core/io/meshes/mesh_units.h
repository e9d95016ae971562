#pragma once

// The folder core/io/meshes reads mesh files (OBJ, PLY, glTF 2, STL, COLLADA, IFC, DXF). mesh_buildings.cpp
// runs the steps: mesh_reader_process.h starts the process that parses the file (core/mesh_reader) and
// returns a MeshScene (mesh_scene.h); mesh_placement.h says where it lies; mesh_units.h (this file) divides
// its objects into buildings with unit_joins.h and separate_roofs.h, which also reads the objects' names;
// mesh_buildings.h makes parts from them by core/city/meshes.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stop_token>
#include <string>
#include <vector>

#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/io/meshes/mesh_buildings.h"

namespace noonmark {

/// The geometry of one building of a mesh file.
struct MeshUnit {
    TriangleMesh mesh;
    std::size_t object = 0;  ///< index of the object that gives its name
};

/// Points nearer to each other than this are one, metres.
inline constexpr float touchM = 0.01F;

/// What a mesh covers in plan.
inline std::vector<Footprint> computeCover(const TriangleMesh& mesh) {
    return computeOutline(mesh, findOpenEdges(mesh) == 0).pieces;
}

/// Sets of indices that are joined pair by pair. The lowest index of a set stands for it.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t(0));
    }
    std::size_t of(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = of(a), b = of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

/// An edge as the indices of its welded ends, in either direction.
inline std::uint64_t edgeOf(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t(std::min(a, b)) << 32U) | std::max(a, b);
}

/// Joins objects that are surfaces of one building, according to their names (separate_roofs.h), or according
/// to their parent's name if their own only names a surface ("building 12" over "WallSurface" and
/// "RoofSurface"). They are joined if together they cover one connected area; other objects stay unchanged.
std::vector<NamedMesh> joinSurfaces(const std::vector<NamedMesh>& objects);

/// Divides objects into buildings. Pieces of one object belong together if they share points or overlap in
/// plan (a shared wall line is not enough). Walls without roofs belong to the roofs above them, of their own
/// object or else of another:
/// - Roofs distinguish buildings: roofs that share an edge belong to one building, unless a wall ends there
///   (the party wall between neighbours). Walls join nothing.
/// - Each face of a wall belongs to the roof over it, or within 0.25 m of it in plan; of several roofs to the
///   one whose points are nearest to the face's top.
/// - Walls that do not reach the ground but rise from the edge of another roof belong to that roof, together
///   with what they carry. The same holds for a piece that starts above the ground with lower buildings
///   around half of its outline. (A canopy has them on one side.)
/// - A level sheet between the foot and the top of one building that covers nine tenths of it is its floor.
///
/// Walls under no roof belong to the only building of their object, otherwise they are buildings of their
/// own. Level sheets at the ground (groundSheetM) are left out. The order is that of the objects. After a
/// stop request the result is incomplete. Warnings name `file`.
std::vector<MeshUnit> detectUnits(const std::vector<NamedMesh>& objects, const std::string& file,
                                  Warnings& warnings, const std::stop_token& stop);

/// A level sheet is ground if it is at most this high above z = 0, metres, or at the lowest level of its file
/// with two or more meshes that begin on it (one is enough up to openAirM above z = 0).
inline constexpr float groundSheetM = 0.1F;

}  // namespace noonmark
