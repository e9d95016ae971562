// A project file with changed cells.
#include "scenarios/project/project_file.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/project_use.h"
#include "tests/fuzz/small_project.h"
#include "tests/fuzz/table_edits.h"

namespace {

noonmark::tests::TableEdits goodFile() {
    const auto file = noonmark::tests::fuzzFolder() / "good.noonmark.gpkg";
    const auto made = noonmark::ProjectFile::create(file, noonmark::tests::smallProject());
    noonmark::tests::require(made.has_value(), "a project is written");
    return noonmark::tests::TableEdits(file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    static const TableEdits edits = goodFile();
    const Save save = size % 4 == 0 ? Save::yes : Save::no;
    useProject(edits.edited("project.noonmark.gpkg", {data, size}), save);
    return 0;
}
