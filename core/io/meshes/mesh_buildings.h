#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/city/meshes/mesh.h"
#include "core/io/meshes/mesh_scene.h"
#include "core/io/read_part.h"

namespace noonmark {

/// One object of a mesh file, in local metres.
struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
    std::string parent = {};   ///< name of the object that holds it; empty for none
    bool oneBuilding = false;  ///< by its name: not to be cut into several
};

/// Adds the buildings of mesh objects to a piece. An object is one building, or several where its pieces
/// stand apart, so a whole city in one object becomes buildings; walls and roofs that are objects of their
/// own are joined (mesh_units.h). Level sheets on which others stand, or at the ground (no more than 0.1 m
/// above z = 0), are ground and left out; one up to 2 m above z = 0 is solid down to it; others are overhangs
/// or roofs. False when stopped.
bool addBuildings(const std::vector<NamedMesh>& objects, const std::string& file, FilePiece& piece,
                  Progress& progress, const std::stop_token& stop);

/// What readMesh() makes of the scene that the reader's process handed over, which may hold anything. `file`:
/// for messages; it is not opened. In read_mesh.cpp.
Result<FilePiece> describeScenePiece(const MeshScene& scene, const std::filesystem::path& file,
                                     const ReadSettings& settings, Progress& progress,
                                     const std::stop_token& stop);

}  // namespace noonmark
