#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/city/meshes/mesh.h"
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
/// objects are joined (mesh_units.h). Level sheets that buildings stand on, or at the ground (no more than
/// 0.1 m above z = 0), are ground and left out; one up to 2 m above z = 0 is solid down to it; others are
/// overhangs or roofs. False when stopped.
bool addBuildings(const std::vector<NamedMesh>& objects, const std::string& file, FilePiece& piece,
                  Progress& progress, const std::stop_token& stop);

/// Makes the result of readMesh() from the scene that the reader process returned; the scene is untrusted.
/// `file`: for messages; it is not opened. Defined in mesh_buildings.cpp.
Result<FilePiece> describeScenePiece(const MeshScene& scene, const std::filesystem::path& file,
                                     const ReadSettings& settings, Progress& progress,
                                     const std::stop_token& stop);

}  // namespace noonmark
