// An aerial photograph as GeoTIFF.
#include "core/io/pictures/ground_raster_file.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    const auto file = fuzzFile("photograph.tif", formatText(data, size));
    NoProgress quiet;
    (void)isGroundPicture(file);
    const auto read = readGroundRaster(file, Frame({-73.98, 40.75}), {{-200, -200}, {200, 200}},
                                       {.maxPixels = 256, .finestM = 1}, quiet, {});
    if (!read) return requireSound(read.error()), 0;
    require(read->rgba.size() == 4 * read->grid.size(), "a colour for each cell");
    return 0;
}
