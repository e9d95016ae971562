// Places and streets of OpenStreetMap XML.
#include "core/io/places/read_places.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    const auto file = fuzzFile("city.osm", formatText(data, size));
    NoProgress quiet;
    const bool sidewalks = size % 2 == 1;
    const auto read = readPlaces(file, {.streets = true, .sidewalkM = sidewalks ? 3.0 : 0.0},
                                 Frame({-73.98, 40.75}), quiet, {});
    if (!read) return requireSound(read.error()), 0;
    for (const Place& place : read->places) requireSound(place.polygons);
    return 0;
}
