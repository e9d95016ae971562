#pragma once

// The folder core/mesh_reader is the program noonmark-mesh-reader, which parses one untrusted mesh file in a
// process of its own and writes the scene to its parent (core/io/meshes/mesh_reader_process.h). main.cpp runs
// the steps: own_limits.h limits the process, mesh_file_check.h refuses hostile files, and readScene() (this
// file) parses with Assimp, whose access to files is in read_scene_assimp.cpp.

#include <filesystem>
#include <functional>

#include "core/io/meshes/mesh_scene.h"

namespace noonmark {

/// Reads a mesh file and passes on its objects one by one, with the transformations in the file's tree
/// applied. Points and lines are left out; polygons stay polygons. The polygons of mirrored objects are
/// reversed, so that they still face outward. Backend: read_scene_assimp.cpp, which supports OBJ, PLY, glTF 2
/// and IFC only. DXF: read_dxf.h.
Result<void> readScene(const std::filesystem::path& file, const std::function<void(const MeshObject&)>& take);

}  // namespace noonmark
