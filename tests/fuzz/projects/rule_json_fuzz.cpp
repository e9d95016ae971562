// The rule of a review board.
#include "core/review/library/read_rule.h"
#include "core/review/library/rule_text.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const std::string text(formatText(data, size));
    const auto rule = noonmark::parseRule(text, "rule.json");
    if (!rule) return requireSound(rule.error()), 0;
    require(!rule->key.empty() && rule->sampling.stepMinutes > 0, "a rule that is read is complete");
    require(!noonmark::describeRule(*rule).empty(), "a rule can be shown");
    for (const auto& [choice, options] : rule->choices)
        for (const std::string& option : options)
            if (const auto other = noonmark::parseRule(text, "rule.json", {{choice, option}}); !other)
                requireSound(other.error());
    return 0;
}
