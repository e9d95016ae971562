// Trees of an inventory: a table, or GeoJSON where the text begins like it.
#include "core/io/trees/list_trees.h"
#include "tests/fuzz/sound_trees.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const std::string_view text = formatText(data, size);
    const auto file = fuzzFile(text.starts_with('{') ? "trees.geojson" : "trees.csv", text);
    if (const auto listed = noonmark::listTrees(file, {}); !listed) requireSound(listed.error());
    useTrees(file);
    return 0;
}
