// A table of time weights as CSV.
#include "scenarios/weights/time_weights.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const auto weights = noonmark::parseWeightsCsv(formatText(data, size), "table");
    if (!weights) return requireSound(weights.error()), 0;
    const auto again = noonmark::parseWeightsCsv(noonmark::weightsCsv(*weights), "table");
    require(again.has_value(), "a table that is written is read");
    return 0;
}
