// Canopy heights as GeoTIFF.
#include "tests/fuzz/sound_trees.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    useTrees(fuzzFile("canopy.tif", formatText(data, size)));
    return 0;
}
