// A map saved by a study: a tile of a journal.
#include "core/io/write_raster.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const noonmark::Grid grid{0, 0, 2, 12, 9};
    const auto bands = noonmark::readGeoTiff(fuzzFile("map.tif", formatText(data, size)), grid);
    if (!bands) return requireSound(bands.error()), 0;
    for (const auto& band : *bands) require(band.size() == grid.size(), "a band has the grid's size");
    return 0;
}
