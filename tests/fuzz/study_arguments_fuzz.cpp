// The arguments of a study in the plan of its tiles, one a line.
#include <sstream>

#include "app/cli/tiles/study_arguments.h"
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
    const auto study = cli::parseArguments(arguments);
    if (!study) return requireSound(study.error()), 0;
    require(validate(study->settings.period).has_value(), "a study that is accepted has a valid period");
    return 0;
}
