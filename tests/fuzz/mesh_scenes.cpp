#include "tests/fuzz/mesh_scenes.h"

#include <exception>

#include "core/io/meshes/mesh_units.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

namespace noonmark::tests {

namespace {

// Compares bytes, because numbers of corrupt files may be NaN, which is not equal to itself.
std::string bytesOf(const MeshScene& scene) {
    std::string bytes;
    appendSceneHead(bytes);
    for (const MeshObject& object : scene) appendObject(bytes, object);
    appendSceneEnd(bytes);
    return bytes;
}

}  // namespace

ReadSettings meshSettings() {
    ReadSettings settings;
    settings.upAxis = UpAxis::z;
    settings.meshAnchor = LonLat{-73.98, 40.75};
    return settings;
}

void useScene(const MeshScene& scene) {
    const std::string bytes = bytesOf(scene);
    bool complete = false;
    const auto again = parseScene(bytes, complete);
    require(again && complete && bytesOf(*again) == bytes, "a scene comes back as it was handed over");
    NoProgress progress;
    try {
        use(describeScenePiece(*again, "mesh.obj", meshSettings(), progress, {}));
    } catch (const std::exception&) {
        // readMesh() turns this into an Error.
    }
}

}  // namespace noonmark::tests
