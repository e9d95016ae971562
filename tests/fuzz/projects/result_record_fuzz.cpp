// The record of a result that a report contains, and its comparison with another one.
#include <algorithm>

#include "core/study/verification/result_record.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    const auto record = parseResultRecord(std::string(formatText(data, size)), {"study"}, "study.json");
    if (!record) return requireSound(record.error()), 0;
    require(record->command.size() > 3 && record->command[0] == "noonmark-cli", "a command is one of ours");
    for (const std::string& word : record->command)
        require(word.find("..") == word.npos || word.find('/') == word.npos, "words stay in the folder");
    for (const char* option : {"--save", "--keep", "--overwrite"})
        require(
            std::ranges::none_of(record->command,
                                 [&](const auto& word) { return word.substr(0, word.find('=')) == option; }),
            "a command changes no project");
    (void)compareRecords(record->json, record->json);
    return 0;
}
