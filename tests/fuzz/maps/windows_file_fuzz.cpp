// Windows as points and panes of a map.
#include <cmath>

#include "core/io/elements/read_glazing.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    const auto file = fuzzFile("windows.geojson", formatText(data, size));
    City city;
    city.frame = Frame({-73.98, 40.75});
    NoProgress quiet;
    const auto read = readGlazing(file, {}, city, quiet, {});
    if (!read) return requireSound(read.error()), 0;
    require(!read->windows.empty(), "a file without windows is an error");
    for (const GlazingShape& window : read->windows) {
        require(!window.id.empty() && !window.corners.empty(), "a window has an id and a place");
        for (const glm::dvec3& corner : window.corners)
            require(std::isfinite(corner.x) && std::isfinite(corner.y) && std::isfinite(corner.z),
                    "a corner that is not finite");
    }
    return 0;
}
