// Wavefront OBJ, read in this process. In the product its reader runs in a process of its own. It is compiled
// here: no other target has a use for it.
#include "core/mesh_reader/read_obj.cpp"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/mesh_scenes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const auto file = fuzzFile("mesh.obj", formatText(data, size));
    if (!noonmark::checkMeshFile(file) || !noonmark::isObj(file)) return 0;
    noonmark::MeshScene scene;
    if (noonmark::readObj(file, [&](const noonmark::MeshObject& object) { scene.push_back(object); }))
        useScene(scene);
    return 0;
}
