// The settings of a saved result, which contain its figures. The first byte selects the kind of result.
#include <limits>

#include "scenarios/project/results/saved_answer.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    constexpr const char* kinds[] = {"study", "impact", "score"};
    if (size == 0) return 0;
    noonmark::SavedResult result{.name = "result", .kind = kinds[data[0] % std::size(kinds)]};
    result.settings = formatText(data, size).substr(1);
    result.grid = {0, 0, 2, 4, 3};
    for (int layer = 0; layer < 2; ++layer)
        result.layers.push_back({"layer", "min/day", std::vector<float>(result.grid.size(), float(layer))});
    const auto answer = noonmark::readSavedAnswer(result);
    if (!answer) requireSound(answer.error());
    return 0;
}
