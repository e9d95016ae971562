// A project file with arbitrary bytes changed.
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/project_use.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    useProject(fuzzFile("project.noonmark.gpkg", formatText(data, size)), Save::yes);
    return 0;
}
