#pragma once

#include "core/io/meshes/mesh_scene.h"
#include "core/io/read_city.h"

namespace noonmark::tests {

/// Settings with which a mesh has a place.
ReadSettings meshSettings();

/// A scene is handed over as the reader's process does it, and its buildings are found.
void useScene(const MeshScene& scene);

}  // namespace noonmark::tests
