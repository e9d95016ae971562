// Terrain as GeoTIFF.
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    noonmark::NoProgress progress;
    use(noonmark::readTerrain(fuzzFile("terrain.tif", formatText(data, size)), {}, progress, {}));
    return 0;
}
