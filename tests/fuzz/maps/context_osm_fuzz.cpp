// What maps draw for orientation, of OpenStreetMap XML.
#include "core/io/context/read_context.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    const auto file = fuzzFile("map.osm", formatText(data, size));
    NoProgress quiet;
    const auto read = readContext(file, {}, Frame({-73.98, 40.75}), quiet, {});
    if (!read) return requireSound(read.error()), 0;
    requireSound(read->context);
    return 0;
}
