// A region as a polygon file.
#include "core/io/read_region.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const auto file = fuzzFile("region.geojson", formatText(data, size));
    const auto region = noonmark::readRegion(file.string(), noonmark::Frame({-73.98, 40.75}));
    if (!region) return requireSound(region.error()), 0;
    requireSound(region->polygons);
    return 0;
}
