#pragma once

#include <filesystem>
#include <functional>

#include "core/io/meshes/mesh_scene.h"

namespace noonmark {

/// Reads a mesh file and hands over its objects one by one, each where its place in the file's tree puts it.
/// Points and lines are left out; polygons stay polygons. Mirrored objects have their polygons turned round,
/// so that they still look outward. Backend: read_scene_assimp.cpp, which knows OBJ, PLY and glTF 2 only.
Result<void> readScene(const std::filesystem::path& file, const std::function<void(const MeshObject&)>& take);

}  // namespace noonmark
