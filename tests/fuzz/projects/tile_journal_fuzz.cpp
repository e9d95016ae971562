// The journal of a study in tiles: the lines after the first one, which names the study.
#include "core/study/tiles/tile_journal.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/sound.h"

namespace {

const noonmark::TilePlan plan{{0, 0, 1, 40, 30}, 10};

noonmark::Result<noonmark::TileJournal> openedJournal() {
    return noonmark::TileJournal::open(noonmark::tests::fuzzFolder(), "hash", plan);
}

void requireSame(const noonmark::TileResult& result) {
    const nlohmann::json json = toJson(result);
    const auto again = noonmark::tileResultFrom(json);
    noonmark::tests::require(again && toJson(*again) == json, "a tile's result comes back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const std::string head = R"({"noonmark_tiles":1,"side":10,"study":"hash","tiles":12})"
                             "\n";
    fuzzFile("journal.jsonl", head + std::string(formatText(data, size)) + "\n");
    const auto journal = openedJournal();
    if (!journal) return requireSound(journal.error()), 0;
    for (const auto& [number, result] : journal->finished()) {
        require(number < plan.count() && number == result.number, "a finished tile is one of the plan");
        requireSame(result);
    }
    return 0;
}
