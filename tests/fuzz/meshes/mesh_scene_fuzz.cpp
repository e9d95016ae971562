// The output of the mesh reader's process, possibly corrupt, and the buildings found in it.
#include "core/io/meshes/mesh_scene.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/mesh_scenes.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    (void)fuzzFolder();
    bool complete = false;
    const auto scene = noonmark::parseScene(formatText(data, size), complete);
    if (scene) useScene(*scene);
    return 0;
}
