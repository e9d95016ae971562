// The state of the window that a project contains, with the choice of a review: a line "key value" for each
// text.
#include <sstream>

#include "app/gui/docks/review/review_choice.h"
#include "app/gui/session/project/view_state.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

namespace {

std::map<std::string, std::string> textsIn(std::string_view input) {
    std::map<std::string, std::string> texts;
    std::istringstream lines{std::string(input)};
    for (std::string line; std::getline(lines, line);) {
        const auto space = line.find(' ');
        if (space != line.npos) texts[line.substr(0, space)] = line.substr(space + 1);
    }
    return texts;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    fuzzFolder();
    const ViewState state = parseViewState(textsIn(formatText(data, size)));
    if (state.study) {
        requireSound(state.study->region.polygons);
        require(validate(state.study->period).has_value(), "a restored study has a valid period");
    }
    const auto texts = textsOf(state);
    require(textsOf(parseViewState(texts)) == texts, "a state that is saved is restored");
    const ReviewChoice choice = parseReviewChoice(state.review);
    require(parseReviewChoice(formatText(choice)) == choice, "a choice is restored");
    return 0;
}
