// A region as four numbers or well-known text.
#include "core/io/read_region.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    (void)fuzzFolder();
    const std::string text(formatText(data, size));
    std::error_code ignored;
    if (std::filesystem::exists(text, ignored)) return 0;  // covered by fuzz_region_file
    const auto region = noonmark::readRegion(text, noonmark::Frame({-73.98, 40.75}));
    if (!region) return requireSound(region.error()), 0;
    requireSound(region->polygons);
    return 0;
}
