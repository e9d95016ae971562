#pragma once

#include <filesystem>
#include <functional>

#include "core/io/meshes/mesh_scene.h"

namespace noonmark {

/// Whether a file begins as a DXF, in text or binary form.
bool isDxf(const std::filesystem::path& file);

/// Reads the masses of a DXF drawing in text form: 3DFACE, SOLID, polyface and polygon meshes, and closed
/// outlines with a thickness, in the drawing and in inserted blocks. One object per layer, in the drawing's
/// unit with z up; then a note for each kind of entity that was left out. Error: the file is binary or holds
/// no mass, with what it holds instead. O(file + polygons).
Result<void> readDxf(const std::filesystem::path& file, const std::function<void(const MeshObject&)>& take);

}  // namespace noonmark
