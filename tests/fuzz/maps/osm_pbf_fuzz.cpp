// OpenStreetMap as PBF.
#include "core/io/osm/read_osm_buildings.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    noonmark::NoProgress progress;
    const auto file = fuzzFile("footprints.osm.pbf", formatText(data, size));
    use(noonmark::readOsmFootprints(file, {}, progress, {}));
    return 0;
}
