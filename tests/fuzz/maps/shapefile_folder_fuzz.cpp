// A folder of two Shapefiles whose tables state no encoding. The input holds the lengths of the first one's
// .shp, .shx and .dbf, two bytes each, then their bytes; what is left is the table of the second one, which
// has the same shapes.
#include <algorithm>
#include <array>

#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    constexpr std::array endings{".shp", ".shx", ".dbf"};
    if (size < 2 * endings.size()) return 0;
    std::filesystem::create_directory(fuzzFolder() / "maps");
    std::string_view rest = formatText(data, size).substr(2 * endings.size());
    for (std::size_t i = 0; i < endings.size(); ++i) {
        const std::size_t length = std::min<std::size_t>(data[2 * i] + 256U * data[2 * i + 1], rest.size());
        for (const char* layer : {"maps/buildings", "maps/plots"})
            fuzzFile(std::string(layer) + endings[i], rest.substr(0, length));
        rest.remove_prefix(length);
    }
    if (!rest.empty()) fuzzFile("maps/plots.dbf", rest);
    noonmark::ReadSettings settings;
    settings.crs = "EPSG:4326";
    noonmark::NoProgress progress;
    use(noonmark::readFootprints(fuzzFolder() / "maps", settings, progress, {}));
    return 0;
}
