// An edit of a scenario. The first byte selects its kind.
#include <span>

#include "scenarios/edits/apply_edits.h"
#include "scenarios/project/edit_json.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"
#include "tests/scenarios/small_town.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    constexpr const char* kinds[] = {"demolish", "replace", "add", "height", "move", "rotate", "import", "?"};
    (void)fuzzFolder();
    if (size == 0) return 0;
    const std::string kind = kinds[data[0] % std::size(kinds)];
    const auto edit = noonmark::parseEdit(kind, std::string(formatText(data, size).substr(1)));
    if (!edit) return requireSound(edit.error()), 0;
    const std::string text = toJson(*edit);
    const auto again = noonmark::parseEdit(kind, text);
    require(again && toJson(*again) == text, "an edit comes back");
    const noonmark::City city = threeHouses();
    if (const auto edited = noonmark::applyEdits(city, std::span(&*edit, 1)); edited)
        requireSound(edited->city);
    return 0;
}
