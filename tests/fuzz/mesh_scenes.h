#pragma once

#include "core/io/meshes/mesh_scene.h"
#include "core/io/read_city.h"

namespace noonmark::tests {

/// Settings that give a mesh a position.
ReadSettings meshSettings();

/// Passes a scene on as the reader's process does, and finds its buildings.
void useScene(const MeshScene& scene);

}  // namespace noonmark::tests
