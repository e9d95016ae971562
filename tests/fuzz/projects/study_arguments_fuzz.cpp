// The arguments of a study in the plan of its tiles, one a line.
#include <sstream>

#include "app/cli/tiles/tile_question.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    fuzzFolder();
    std::istringstream lines{std::string(formatText(data, size))};
    std::vector<std::string> arguments;
    for (std::string line; std::getline(lines, line);) arguments.push_back(line);
    const auto options = cli::parseArguments(arguments, {"city.gpkg"});
    if (!options) return requireSound(options.error()), 0;
    const auto period = cli::periodFrom(options->study.period);
    if (!period) return requireSound(period.error()), 0;
    require(validate(*period).has_value(), "a period that is accepted is valid");
    return 0;
}
