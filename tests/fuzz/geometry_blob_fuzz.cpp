// The geometry of lots and regions in a project file.
#include "scenarios/project/geometry_blob.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const auto polygons = noonmark::polygonsOf(textOf(data, size));
    if (!polygons) return 0;
    requireSound(*polygons);
    const auto again = noonmark::polygonsOf(noonmark::multiPolygonBlob(*polygons));
    require(again && *again == *polygons, "polygons come back to the last bit");
    return 0;
}
