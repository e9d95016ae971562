// The geometry of lots, regions and the map in a project file.
#include "scenarios/project/tables/geometry_blob.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    if (const auto points = noonmark::toPoints(formatText(data, size))) {
        const auto again = noonmark::toPoints(noonmark::multiPointBlob(*points));
        require(again && *again == *points, "points come back to the last bit");
    }
    const auto polygons = noonmark::toPolygons(formatText(data, size));
    if (!polygons) return 0;
    requireSound(*polygons);
    const auto again = noonmark::toPolygons(noonmark::multiPolygonBlob(*polygons));
    require(again && *again == *polygons, "polygons come back to the last bit");
    return 0;
}
