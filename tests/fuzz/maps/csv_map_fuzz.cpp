// Footprints as CSV with well-known text.
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    noonmark::NoProgress progress;
    const auto file = fuzzFile("footprints.csv", formatText(data, size));
    use(noonmark::readFootprints(file, {}, progress, {}));
    return 0;
}
