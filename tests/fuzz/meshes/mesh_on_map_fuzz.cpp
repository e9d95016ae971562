// A mesh in map coordinates: the output of the mesh reader's process, possibly corrupt, in one of three
// systems, which the first byte chooses with the unit.
#include <array>

#include "core/io/meshes/mesh_units.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    (void)fuzzFolder();
    if (size == 0) return 0;
    constexpr std::array systems{"EPSG:25833", "EPSG:2263", "EPSG:28992"};
    const auto units = listLengthUnits();
    bool complete = false;
    const auto scene = parseScene(formatText(data + 1, size - 1), complete);
    if (!scene) return 0;
    ReadSettings settings;
    settings.crs = systems[data[0] % systems.size()];
    settings.meshUnit = units[data[0] / systems.size() % units.size()].unit;
    NoProgress progress;
    try {
        use(describeScenePiece(*scene, "mesh.obj", settings, progress, {}));
    } catch (const std::exception&) {
        // readMesh() turns this into an Error.
    }
    return 0;
}
