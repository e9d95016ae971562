// Footprints as Shapefile. The input holds the lengths of its .shp, .shx and .dbf, two bytes each, then their
// bytes; the rest is the .prj. Without a .prj the coordinates are stated to be degrees: interpreting a .prj
// takes ten times as long as everything else.
#include <algorithm>
#include <array>

#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    constexpr std::array names{"footprints.shp", "footprints.shx", "footprints.dbf"};
    if (size < 2 * names.size()) return 0;
    std::string_view rest = formatText(data, size).substr(2 * names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t length = std::min<std::size_t>(data[2 * i] + 256U * data[2 * i + 1], rest.size());
        fuzzFile(names[i], rest.substr(0, length));
        rest.remove_prefix(length);
    }
    fuzzFile("footprints.prj", rest);
    noonmark::ReadSettings settings;
    if (rest.empty()) settings.crs = "EPSG:4326";
    noonmark::NoProgress progress;
    use(noonmark::readFootprints(fuzzFolder() / "footprints.shp", settings, progress, {}));
    return 0;
}
