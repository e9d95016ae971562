// Trees of OpenStreetMap: single ones, rows and woods, beside the buildings of the same file.
#include "core/io/osm/read_osm_buildings.h"
#include "tests/fuzz/sound_trees.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const auto file = fuzzFile("trees.osm", formatText(data, size));
    useTrees(file);
    noonmark::NoProgress progress;
    use(noonmark::readOsmFootprints(file, {}, progress, {}));
    return 0;
}
