// A model of the surface and one of the ground, which make a city without outlines. The input holds the
// length of the first, two bytes, then both files.
#include <algorithm>

#include "core/io/read_city.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    if (size < 2) return 0;
    const std::string_view both = formatText(data, size).substr(2);
    const std::size_t length = std::min<std::size_t>(data[0] + 256U * data[1], both.size());
    const auto surface = fuzzFile("dsm.tif", both.substr(0, length));
    const auto ground = fuzzFile("dtm.tif", both.substr(length));
    noonmark::NoProgress progress;
    const auto city = noonmark::readCity({surface, ground}, {}, progress, {});
    if (!city) return requireSound(city.error()), 0;
    requireSound(city->city);
    return 0;
}
