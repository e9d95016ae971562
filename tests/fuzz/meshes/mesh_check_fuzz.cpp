// The check of a mesh file before the mesh library reads it.
#include "core/mesh_reader/read_scene.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const auto bytes = noonmark::checkMeshFile(fuzzFile("mesh", formatText(data, size)));
    if (!bytes) return requireSound(bytes.error()), 0;
    require(*bytes >= size, "the file's own bytes count");
    return 0;
}
