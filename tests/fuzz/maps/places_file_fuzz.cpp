// Places of a polygon file.
#include "core/io/places/read_places.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    const auto file = fuzzFile("places.geojson", formatText(data, size));
    NoProgress quiet;
    const auto read = readPlaces(file, {}, Frame({-73.98, 40.75}), quiet, {});
    if (!read) return requireSound(read.error()), 0;
    for (const Place& place : read->places) requireSound(place.polygons);
    return 0;
}
