// glTF, as JSON or glb, read in this process. In the product the mesh library runs in a process of its own,
// which contains its faults.
#include "core/mesh_reader/read_scene.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/mesh_scenes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const auto file = fuzzFile(formatText(data, size).starts_with("glTF") ? "mesh.glb" : "mesh.gltf",
                               formatText(data, size));
    if (!noonmark::checkMeshFile(file)) return 0;
    noonmark::MeshScene scene;
    if (noonmark::readScene(file, [&](const noonmark::MeshObject& object) { scene.push_back(object); }))
        useScene(scene);
    return 0;
}
