// Heights, storeys and lists of tags, as found in fields of a map.
#include <cmath>

#include "core/io/files/readable_text.h"
#include "core/io/footprints/feature_facts.h"
#include "core/io/heights/height_text.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const std::string_view text = noonmark::tests::formatText(data, size);
    if (const auto metres = noonmark::parseMetres(text))
        require(std::isfinite(*metres), "a height is finite");
    if (const auto levels = noonmark::parseLevels(text))
        require(std::isfinite(*levels) && *levels >= 0, "storeys are counted from 0");
    const std::string pointed = noonmark::withDecimalPoint(text);
    require(noonmark::withDecimalPoint(pointed) == pointed, "a decimal point stays one");
    (void)noonmark::foldText(text);
    (void)noonmark::parseTags(text);
    return 0;
}
