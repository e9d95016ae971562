// A project file of an earlier version with changed cells. Run in the root of the sources. The first byte
// selects the version.
#include <array>
#include <string>

#include "tests/fuzz/project_use.h"
#include "tests/fuzz/table_edits.h"

namespace {

noonmark::tests::TableEdits fileOf(int version) {
    return noonmark::tests::TableEdits("tests/scenarios/files/version-" + std::to_string(version) +
                                       ".noonmark.gpkg");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    static const std::array edits{fileOf(1), fileOf(2), fileOf(3), fileOf(4),
                                  fileOf(5), fileOf(6), fileOf(7)};
    if (size == 0) return 0;
    const Save save = size % 4 == 0 ? Save::yes : Save::no;
    useProject(edits[data[0] % edits.size()].edited("project.noonmark.gpkg", {data + 1, size - 1}), save);
    return 0;
}
