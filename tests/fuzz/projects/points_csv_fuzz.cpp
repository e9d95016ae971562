// Single points as CSV, and as the table that is written of them.
#include "core/receivers/points/point_list.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    const auto points = parsePointList(formatText(data, size), "points.csv");
    if (!points) return requireSound(points.error()), 0;
    const auto again = parsePointList(toCsv(*points), "again.csv");
    require(again && again->size() == points->size(), "a table that is written is read");
    for (std::size_t i = 0; i < points->size(); ++i)
        require((*again)[i].id == (*points)[i].id && (*again)[i].facingDeg == (*points)[i].facingDeg,
                "a point is read as it was written");
    return 0;
}
