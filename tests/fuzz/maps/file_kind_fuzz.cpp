// Detection of the file kind from the first bytes and, for JSON, the first distinctive key.
#include "core/io/files/plain_file.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const auto kind = noonmark::detectFileKind(fuzzFile("file", formatText(data, size)));
    if (!kind) requireSound(kind.error());
    return 0;
}
