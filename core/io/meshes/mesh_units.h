#pragma once

// The folder core/io/meshes reads mesh files (OBJ, PLY, glTF 2, STL, COLLADA, IFC, DXF). mesh_buildings.cpp
// runs the steps: mesh_reader_process.h starts the process that parses the file (core/mesh_reader) and
// returns a MeshScene (mesh_scene.h); mesh_placement.h says where it lies; this file divides its objects into
// buildings (unit_joins.cpp; separate_roofs.cpp reads the objects' names) and makes parts from them by
// core/city/meshes.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/city/meshes/mesh.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/io/meshes/mesh_scene.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

/// One object of a mesh file, in local metres.
struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
    std::string parent = {};   ///< name of the object that contains it; empty for none
    bool oneBuilding = false;  ///< its name says that it is one building: not to be split
};

/// Adds the buildings of mesh objects to a piece. An object is one building, or several if its pieces stand
/// apart, so that a whole city in one object is split into buildings; walls and roofs that are separate
/// objects are joined. Level sheets that buildings stand on, or at the ground (no more than
/// 0.1 m above z = 0), are ground and left out; one up to 2 m above z = 0 is solid down to it; others are
/// overhangs or roofs. False when stopped.
bool addBuildings(const std::vector<NamedMesh>& objects, const std::string& file, FilePiece& piece,
                  Progress& progress, const std::stop_token& stop);

/// Makes the result of readMesh() from the scene that the reader process returned; the scene is untrusted.
/// `file`: for messages; it is not opened. Defined in mesh_buildings.cpp.
Result<FilePiece> describeScenePiece(const MeshScene& scene, const std::filesystem::path& file,
                                     const ReadSettings& settings, Progress& progress,
                                     const std::stop_token& stop);

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

/// An edge as the indices of its welded ends, in either direction.
inline std::uint64_t edgeOf(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t(std::min(a, b)) << 32U) | std::max(a, b);
}

/// Joins objects that are surfaces of one building, according to their names, or according
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

/// An object's name without the words for surfaces of a building (WallSurface, roof, Dach, window, ...) and
/// the numbers after them: "building_12" for "building_12_WallSurface_3", "House 7" for "Roof House 7" (words
/// joined by _). Empty if the name has no such word, if nothing is left, or if only a number is left and the
/// word is not one of CityGML's ("roof 3" is the third roof, not the roof of building 3). Case does not
/// matter. A word ends at a character that is neither letter nor digit, and before a capital that follows a
/// small letter or digit.
std::string stemOfSurfaceName(std::string_view name);

/// Whether a name consists of such words and numbers only: "RoofSurface", "walls_2".
bool isOnlySurfaceName(std::string_view name);

/// Takes the roofs (sheets without walls) among `units` apart: faces that share an edge belong to one roof,
/// unless a wall ends at that edge. The other units come first and stay as they are.
std::vector<MeshUnit> separateRoofs(std::vector<MeshUnit> units, const std::vector<MeshUnit>& walls);

/// Joins units whose lowest edges lie on the edges of a lower unit: a higher roof and the walls that rise to
/// it from the surrounding roof.
std::vector<MeshUnit> joinSteps(const std::vector<MeshUnit>& units);

/// Joins floors and ceilings that are separate meshes with the units that contain them.
void joinFloors(std::vector<MeshUnit>& units);

/// Which units take walls that lie under them.
enum class Under { openRoofs, anyRoof };

/// Adds each face of a wall to the unit over it, or within 0.25 m of it in plan; of several to the one whose
/// points are nearest to the face's top. Returns the walls that are under none.
std::vector<MeshUnit> assignWalls(std::vector<MeshUnit>& units, Under under,
                                  const std::vector<MeshUnit>& walls);

/// Adds walls without a roof: they join the only unit of their object; otherwise each connected set of them
/// is a unit.
void addWalls(const std::vector<MeshUnit>& walls, std::vector<MeshUnit>& units);

}  // namespace noonmark
