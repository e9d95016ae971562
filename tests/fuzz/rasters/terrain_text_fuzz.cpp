// Terrain as text: ESRI and GRASS ASCII grids, XYZ, USGS DEM, detected by content.
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    noonmark::NoProgress progress;
    use(noonmark::readTerrain(fuzzFile("terrain.asc", formatText(data, size)), {}, progress, {}));
    return 0;
}
