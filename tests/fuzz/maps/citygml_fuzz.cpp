// CityGML 1.0, 2.0 and 3.0.
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    noonmark::NoProgress progress;
    use(noonmark::readCityGml(fuzzFile("city.gml", formatText(data, size)), {}, progress, {}));
    return 0;
}
